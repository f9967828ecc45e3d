/* SPDX-License-Identifier: MIT
 *
 * Components whole: merged, and handed out as blobs.
 */
#include "component.h"

static inline ocel_moment_t sum_of_x(const ocel_row_sums_t *sums) {
    return (sums->second - sums->first) >> 1U;
}

static inline ocel_moment_t sum_of_xx(const ocel_row_sums_t *sums, ocel_moment_t sum_x) {
    return (sums->third - sums->second - sum_x) * OCEL_INVERSE_OF_3;
}

void ocel_component_add(ocel_component_t *component, const ocel_row_sums_t *sums, uint32_t left,
                        uint32_t end, uint32_t y) {
    const ocel_moment_t sum_x = sum_of_x(sums);
    const ocel_moment_t n_y = (ocel_moment_t)sums->first * y;

    component->sum_x += sum_x;
    component->sum_xx += sum_of_xx(sums, sum_x);
    component->sum_xy += sum_x * y;
    component->sum_y += n_y;
    component->sum_yy += n_y * y;
    component->area += sums->first;
    if (component->left > left) {
        component->left = (uint16_t)left;
    }
    if (component->end < end) {
        component->end = (uint16_t)end;
    }
}

void ocel_component_repeat(ocel_component_t *component, uint32_t start, uint32_t end,
                           const ocel_rows_t *rows) {
    ocel_row_sums_t sums = {0U, 0U, 0U};
    ocel_moment_t sum_x;

    ocel_row_sums_add(&sums, start, end);
    sum_x = sum_of_x(&sums);
    component->sum_x += sum_x * rows->count;
    component->sum_xx += sum_of_xx(&sums, sum_x) * rows->count;
    component->sum_xy += sum_x * rows->sum_y;
    component->sum_y += sums.first * rows->sum_y;
    component->sum_yy += sums.first * rows->sum_yy;
    component->area += (uint32_t)(sums.first * rows->count);
}

void ocel_component_start(ocel_component_t *component, uint32_t start, uint32_t end, uint32_t y) {
    ocel_row_sums_t sums = {0U, 0U, 0U};

    component->sum_x = 0U;
    component->sum_y = 0U;
    component->sum_xx = 0U;
    component->sum_xy = 0U;
    component->sum_yy = 0U;
    component->area = 0U;
    component->first = (y << 16U) | start;
    component->left = (uint16_t)start;
    component->end = 0U;
    ocel_row_sums_add(&sums, start, end);
    ocel_component_add(component, &sums, start, end, y);
}

void ocel_component_merge(ocel_component_t *whole, const ocel_component_t *part) {
    whole->sum_x += part->sum_x;
    whole->sum_y += part->sum_y;
    whole->sum_xx += part->sum_xx;
    whole->sum_xy += part->sum_xy;
    whole->sum_yy += part->sum_yy;
    whole->area += part->area;
    if (whole->first > part->first) {
        whole->first = part->first;
    }
    if (whole->left > part->left) {
        whole->left = part->left;
    }
    if (whole->end < part->end) {
        whole->end = part->end;
    }
}

void ocel_component_blob(const ocel_component_t *component, uint32_t bottom, uint32_t width,
                         uint32_t height, ocel_blob_t *blob) {
    const uint32_t top = component->first >> 16U;

    blob->box.left = component->left;
    blob->box.top = (uint16_t)top;
    blob->box.width = (uint16_t)(component->end - component->left);
    blob->box.height = (uint16_t)((bottom - top) + 1U);
    blob->first_x = (uint16_t)(component->first & 0xFFFFU);
    blob->touches_edge = (component->left == 0U) || (top == 0U) || (component->end == width) ||
                         ((bottom + 1U) == height);
    blob->area = component->area;
    blob->sum_x = component->sum_x;
    blob->sum_y = component->sum_y;
    blob->sum_xx = component->sum_xx;
    blob->sum_xy = component->sum_xy;
    blob->sum_yy = component->sum_yy;
}
