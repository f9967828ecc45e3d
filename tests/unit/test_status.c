/* SPDX-License-Identifier: MIT */
#include <string.h>

#include <ocellus/status.h>

#include "unity.h"

void setUp(void) {
}

void tearDown(void) {
}

/* The names are what scripts read: each is held here in full. */
static const struct {
    ocel_status_t status;
    const char *name;
} EXPECTED[] = {
    {OCEL_OK, "ok"},
    {OCEL_PARTIAL, "partial"},
    {OCEL_CLIPPED, "clipped"},
    {OCEL_NOT_SEEN, "not_seen"},
    {OCEL_TOO_FEW_POINTS, "too_few_points"},
    {OCEL_DEGENERATE, "degenerate"},
    {OCEL_NOT_AN_ELLIPSE, "not_an_ellipse"},
    {OCEL_OVERFLOW, "overflow"},
    {OCEL_OUT_OF_RANGE, "out_of_range"},
    {OCEL_NULL_ARGUMENT, "null_argument"},
    {OCEL_BAD_SIZE, "bad_size"},
    {OCEL_BAD_STRIDE, "bad_stride"},
    {OCEL_BAD_FORMAT, "bad_format"},
    {OCEL_BAD_OPTION, "bad_option"},
    {OCEL_BAD_ORDER, "bad_order"},
};

enum { STATUS_COUNT = (int)(sizeof(EXPECTED) / sizeof(EXPECTED[0])) };

static void every_status_has_its_name(void) {
    for (int i = 0; i < STATUS_COUNT; i++) {
        TEST_ASSERT_EQUAL_INT(i, (int)EXPECTED[i].status); /* none is left out above */
        TEST_ASSERT_EQUAL_STRING(EXPECTED[i].name, ocel_status_name(EXPECTED[i].status));
    }
    TEST_ASSERT_EQUAL_INT((int)OCEL_BAD_ORDER + 1, STATUS_COUNT);
}

static void ok_is_zero(void) {
    TEST_ASSERT_EQUAL_INT(0, (int)OCEL_OK);
}

/* Values that fit the enumeration's type, be it a byte as on Arm, but name nothing. */
static void other_values_are_unknown(void) {
    const int last = (sizeof(ocel_status_t) == 1U) ? 255 : 300;
    for (int v = (int)OCEL_BAD_ORDER + 1; v <= last; v++) {
        TEST_ASSERT_EQUAL_STRING("unknown", ocel_status_name((ocel_status_t)v));
    }
    TEST_ASSERT_EQUAL_STRING("unknown", ocel_status_name((ocel_status_t)0x7FFFFFFF));
}

int main(void) {
    UNITY_BEGIN();
    RUN_TEST(every_status_has_its_name);
    RUN_TEST(ok_is_zero);
    RUN_TEST(other_values_are_unknown);
    return UNITY_END();
}
