/* SPDX-License-Identifier: MIT
 *
 * What the accuracy programs share: a table that goes to stdout and to the file
 * that argv names, percentiles, and claims that decide the exit status.
 */
#ifndef ACCURACY_REPORT_H
#define ACCURACY_REPORT_H

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    FILE *file; /* may be null */
    int failed;
} report_t;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static inline void
report_line(report_t *report, const char *format, ...) {
    va_list args;
    va_start(args, format);
    (void)vprintf(format, args);
    va_end(args);
    if (report->file != NULL) {
        va_start(args, format);
        (void)vfprintf(report->file, format, args);
        va_end(args);
    }
}

/* Opens argv[1], when given, for the table. */
static inline report_t report_open(int argc, char **argv) {
    report_t report = {NULL, 0};
    if (argc > 1) {
        report.file = fopen(argv[1], "w");
        if (report.file == NULL) {
            (void)fprintf(stderr, "%s: cannot write\n", argv[1]);
            exit(2);
        }
    }
    return report;
}

/* A figure that must hold: value <= limit. */
static inline void report_claim(report_t *report, const char *what, double value, double limit) {
    const bool holds = value <= limit; /* false for a NaN */
    report_line(report, "claim: %s: %.6g <= %.6g: %s\n", what, value, limit,
                holds ? "holds" : "FAILS");
    report->failed += holds ? 0 : 1;
}

/* The program's exit status. */
static inline int report_close(report_t *report) {
    if (report->file != NULL) {
        (void)fclose(report->file);
    }
    return (report->failed == 0) ? 0 : 1;
}

static inline int report_compare(const void *p, const void *q) {
    const double a = *(const double *)p;
    const double b = *(const double *)q;
    return (a > b) - (a < b);
}

/* The value below which `share` of the values lie; sorts them. */
static inline double report_percentile(double *values, size_t count, double share) {
    qsort(values, count, sizeof(double), report_compare);
    const size_t at = (size_t)(share * (double)(count - 1U) + 0.5);
    return (count == 0U) ? NAN : values[at];
}

#endif
