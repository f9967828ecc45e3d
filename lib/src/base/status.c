/* SPDX-License-Identifier: MIT
 *
 * Status names, as the command line prints them.
 */
#include <ocellus/status.h>

const char *ocel_status_name(ocel_status_t status) {
    const char *name;

    /* A switch, not a table: the compiler reports a value that is added to the
     * enumeration without a name, and there is no index to go out of bounds. */
    switch (status) {
    case OCEL_OK:
        name = "ok";
        break;
    case OCEL_PARTIAL:
        name = "partial";
        break;
    case OCEL_CLIPPED:
        name = "clipped";
        break;
    case OCEL_NOT_SEEN:
        name = "not_seen";
        break;
    case OCEL_TOO_FEW_POINTS:
        name = "too_few_points";
        break;
    case OCEL_DEGENERATE:
        name = "degenerate";
        break;
    case OCEL_NOT_AN_ELLIPSE:
        name = "not_an_ellipse";
        break;
    case OCEL_OVERFLOW:
        name = "overflow";
        break;
    case OCEL_OUT_OF_RANGE:
        name = "out_of_range";
        break;
    case OCEL_NULL_ARGUMENT:
        name = "null_argument";
        break;
    case OCEL_BAD_SIZE:
        name = "bad_size";
        break;
    case OCEL_BAD_STRIDE:
        name = "bad_stride";
        break;
    case OCEL_BAD_FORMAT:
        name = "bad_format";
        break;
    case OCEL_BAD_OPTION:
        name = "bad_option";
        break;
    case OCEL_BAD_ORDER:
        name = "bad_order";
        break;
    default:
        name = "unknown";
        break;
    }
    return name;
}
