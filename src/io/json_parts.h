/* json_parts: what the files of json share: which values a file may hold, members of a document, and each file's reading and writing.
 * Their names begin with json_file_: other names in json_ are of jansson. */
#ifndef IO_JSON_PARTS_H
#define IO_JSON_PARTS_H
#include "etalon/io/json.h"
#include <jansson.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { JSON_FILE_PLACE = 120 };

/* Counts are JSON integers, which jansson keeps as signed 64-bit numbers. */
static const size_t json_file_greatest_count = SIZE_MAX / 2;

/* ---- what a file may hold ---- */

/* "bottom", "top". */
const char *json_file_view_name(size_t w);
/* The name of approach number k; null past the last, here and below. */
const char *json_file_approach_name(int k);
/* The name of parameterisation number k. */
const char *json_file_method_name(int k);
/* The name of knot rule number k. */
const char *json_file_knots_name(int k);
/* The name of solver number k. */
const char *json_file_algebra_name(int k);
/* The name of corner rule number k. */
const char *json_file_corners_name(int k);
/* Whether all of x[0 .. n-1] are in [lo, hi]. */
int json_file_reals_valid(const double *x, size_t n, double lo, double hi);
/* Parameters: from 0 to 1, non-decreasing. */
int json_file_parameters_valid(const double *t, size_t n);
/* Whether a net file may hold n. */
int json_file_net_valid(const et_net_file *n);
/* Whether a surface file may hold s. */
int json_file_surface_valid(const et_surface_file *s);

/* ---- writing ---- */

/* The members of a net file after format and version, and the last brace. */
void json_file_put_net(FILE *out, const et_net_file *n);
/* The members of a surface file after format and version, and the last brace. */
void json_file_put_surface(FILE *out, const et_surface_file *s);

/* ---- reading: each gives ET_OK, or another status with the message of what is wrong and where ---- */

/* Where a document comes from, and where the message goes. */
typedef struct { const char *path; et_message *message; } json_file_source;

/* A value of the document and the way to it from the top, as in a.b.c. */
typedef struct { const json_t *value; char name[JSON_FILE_PLACE]; } json_file_place;

/* ET_EFORMAT, and the message. */
et_status json_file_wrong(const json_file_source *d, const json_file_place *at, const char *what);
/* ET_ENOMEM, and the message. */
et_status json_file_no_memory(const json_file_source *d);
/* child: the member `name` of the object `parent`. */
et_status json_file_member(const json_file_source *d, json_file_place *child, const json_file_place *parent, const char *name);
/* A real member in [lo, hi]. */
et_status json_file_get_real(const json_file_source *d, double *x, const json_file_place *parent, const char *name, double lo, double hi);
/* A member that is a count, not below `least`. */
et_status json_file_get_count(const json_file_source *d, size_t *n, const json_file_place *parent, const char *name, size_t least);
/* A count that follows from others: where it is given it must agree. */
et_status json_file_check_count(const json_file_source *d, const json_file_place *parent, const char *name, size_t wanted);
/* A member that is one of choice_name(0), choice_name(1), ...; its number. */
et_status json_file_get_choice(const json_file_source *d, int *choice, const json_file_place *parent, const char *name,
                               const char *(*choice_name)(int));
/* A 64-bit number as a string of decimal digits. */
et_status json_file_get_digits(const json_file_source *d, uint64_t *x, const json_file_place *parent, const char *name);
/* *at: a member that is an array of n elements. */
et_status json_file_get_array(const json_file_source *d, json_file_place *at, const json_file_place *parent, const char *name, size_t n);
/* The elements of an array, reals in [lo, hi]. */
et_status json_file_fill_reals(const json_file_source *d, double *x, const json_file_place *at, double lo, double hi);
/* The elements of an array, pairs of reals in [0, 1]. */
et_status json_file_fill_pairs(const json_file_source *d, double *x, const json_file_place *at);
/* The elements of an array, points. */
et_status json_file_fill_points(const json_file_source *d, et_vec3 *points, const json_file_place *at);
/* The top's member frame. */
et_status json_file_get_frame(const json_file_source *d, et_frame *frame, const json_file_place *top);
/* The members nx, ny: sides of a valid net. */
et_status json_file_get_sides(const json_file_source *d, et_doublenet *net, const json_file_place *at);
/* A net file's members after format and version; n is zeroed before, and the caller frees it, whatever the status. */
et_status json_file_read_net(const json_file_source *d, et_net_file *n, const json_file_place *top);
/* A surface file's members after format and version; s is zeroed before, and the caller frees it, whatever the status. */
et_status json_file_read_surface(const json_file_source *d, et_surface_file *s, const json_file_place *top);
#endif
