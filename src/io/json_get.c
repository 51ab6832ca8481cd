/* Members of a document: found, checked for their type and range, and named in full where they are at fault. */
#include "io/json_parts.h"
#include <stdint.h>
#include <string.h>

et_status json_file_wrong(const json_file_source *d, const json_file_place *at, const char *what)
{
    return et_status_fail(d->message, ET_EFORMAT, "%s: %s%s%s", d->path, at->name, *at->name ? ": " : "", what);
}

static et_status wrong_element(const json_file_source *d, const json_file_place *at, size_t k, const char *what)
{
    return et_status_fail(d->message, ET_EFORMAT, "%s: %s[%zu]: %s", d->path, at->name, k, what);
}

et_status json_file_no_memory(const json_file_source *d)
{
    return et_status_fail(d->message, ET_ENOMEM, "out of memory while reading %s", d->path);
}

/* way: parent.name; every name is one of this file's own, and all of them fit. */
static void extend(char way[JSON_FILE_PLACE], const char *parent, const char *name)
{
    size_t n = strlen(parent), m = strlen(name);
    size_t dot = n > 0 ? 1 : 0;
    if (n + dot + m >= JSON_FILE_PLACE)
        m = JSON_FILE_PLACE - 1 - n - dot;
    memmove(way, parent, n);
    if (dot)
        way[n] = '.';
    memcpy(way + n + dot, name, m);
    way[n + dot + m] = 0;
}

et_status json_file_member(const json_file_source *d, json_file_place *child, const json_file_place *parent, const char *name)
{
    if (!json_is_object(parent->value))
        return json_file_wrong(d, parent, "is not an object");
    child->value = json_object_get(parent->value, name);
    extend(child->name, parent->name, name);
    return child->value ? ET_OK : json_file_wrong(d, child, "is missing");
}

et_status json_file_get_real(const json_file_source *d, double *x, const json_file_place *parent, const char *name, double lo, double hi)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, parent, name);
    if (status)
        return status;
    if (!json_is_number(at.value))
        return json_file_wrong(d, &at, "is not a number");
    double value = json_number_value(at.value);
    if (!(value >= lo && value <= hi))
        return json_file_wrong(d, &at, "is out of range");
    *x = value;
    return ET_OK;
}

et_status json_file_get_count(const json_file_source *d, size_t *n, const json_file_place *parent, const char *name, size_t least)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, parent, name);
    if (status)
        return status;
    json_int_t value = json_integer_value(at.value);
    if (!json_is_integer(at.value) || value < 0 || (unsigned long long)value > json_file_greatest_count)
        return json_file_wrong(d, &at, "is not a count");
    if ((size_t)value < least)
        return json_file_wrong(d, &at, "is too small");
    *n = (size_t)value;
    return ET_OK;
}

et_status json_file_check_count(const json_file_source *d, const json_file_place *parent, const char *name, size_t wanted)
{
    size_t n = 0;
    et_status status;
    if (!json_object_get(parent->value, name))
        return ET_OK;
    if ((status = json_file_get_count(d, &n, parent, name, 0)) != ET_OK)
        return status;
    return n == wanted ? ET_OK
                       : et_status_fail(d->message, ET_EFORMAT, "%s: %s.%s: is %zu, but follows as %zu", d->path, parent->name, name, n, wanted);
}

et_status json_file_get_choice(const json_file_source *d, int *choice, const json_file_place *parent, const char *name,
                               const char *(*choice_name)(int))
{
    json_file_place at;
    et_status status = json_file_member(d, &at, parent, name);
    if (status)
        return status;
    if (!json_is_string(at.value))
        return json_file_wrong(d, &at, "is not a string");
    for (int k = 0; choice_name(k); k++) {
        if (strcmp(json_string_value(at.value), choice_name(k)) == 0) {
            *choice = k;
            return ET_OK;
        }
    }
    return json_file_wrong(d, &at, "is not a known name");
}

et_status json_file_get_digits(const json_file_source *d, uint64_t *x, const json_file_place *parent, const char *name)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, parent, name);
    if (status)
        return status;
    const char *p = json_string_value(at.value);
    uint64_t value = 0;
    for (; p && *p >= '0' && *p <= '9'; p++) {
        uint64_t digit = (uint64_t)(*p - '0');
        if (value > (UINT64_MAX - digit) / 10)
            break;
        value = 10 * value + digit;
    }
    if (!p || *p || json_string_length(at.value) == 0)
        return json_file_wrong(d, &at, "is not a string of decimal digits below 2^64");
    *x = value;
    return ET_OK;
}

et_status json_file_get_array(const json_file_source *d, json_file_place *at, const json_file_place *parent, const char *name, size_t n)
{
    et_status status = json_file_member(d, at, parent, name);
    if (status)
        return status;
    if (!json_is_array(at->value))
        return json_file_wrong(d, at, "is not an array");
    if (json_array_size(at->value) != n)
        return et_status_fail(d->message, ET_EFORMAT, "%s: %s: has %zu elements, not %zu", d->path, at->name, json_array_size(at->value), n);
    return ET_OK;
}

et_status json_file_fill_reals(const json_file_source *d, double *x, const json_file_place *at, double lo, double hi)
{
    for (size_t k = 0; k < json_array_size(at->value); k++) {
        const json_t *value = json_array_get(at->value, k);
        if (!json_is_number(value))
            return wrong_element(d, at, k, "is not a number");
        x[k] = json_number_value(value);
        if (!(x[k] >= lo && x[k] <= hi))
            return wrong_element(d, at, k, "is out of range");
    }
    return ET_OK;
}

/* The n numbers of element k of an array, itself an array. */
static et_status get_row(const json_file_source *d, double *x, size_t n, const json_file_place *at, size_t k)
{
    const json_t *row = json_array_get(at->value, k);
    int fits = json_is_array(row) && json_array_size(row) == n;
    for (size_t i = 0; i < n && fits; i++) {
        const json_t *value = json_array_get(row, i);
        fits = json_is_number(value);
        x[i] = json_number_value(value);
    }
    return fits ? ET_OK : wrong_element(d, at, k, n == 3 ? "is not an array of three numbers" : "is not an array of two numbers");
}

et_status json_file_fill_pairs(const json_file_source *d, double *x, const json_file_place *at)
{
    et_status status = ET_OK;
    for (size_t k = 0; k < json_array_size(at->value) && !status; k++) {
        status = get_row(d, x + 2 * k, 2, at, k);
        if (!status && !json_file_reals_valid(x + 2 * k, 2, 0, 1))
            status = wrong_element(d, at, k, "is out of range");
    }
    return status;
}

et_status json_file_fill_points(const json_file_source *d, et_vec3 *points, const json_file_place *at)
{
    et_status status = ET_OK;
    for (size_t k = 0; k < json_array_size(at->value) && !status; k++) {
        double x[3] = { 0, 0, 0 };
        status = get_row(d, x, 3, at, k);
        points[k] = (et_vec3){ x[0], x[1], x[2] };
    }
    return status;
}

static et_status get_vector(const json_file_source *d, et_vec3 *p, const json_file_place *parent, const char *name, double lo)
{
    json_file_place at;
    double x[3] = { 0, 0, 0 };
    et_status status = json_file_get_array(d, &at, parent, name, 3);
    if (!status)
        status = json_file_fill_reals(d, x, &at, lo, 0x1.fffffffffffffp1023);
    if (!status)
        *p = (et_vec3){ x[0], x[1], x[2] };
    return status;
}

et_status json_file_get_frame(const json_file_source *d, et_frame *frame, const json_file_place *top)
{
    json_file_place at;
    et_status status = json_file_member(d, &at, top, "frame");
    if (!status)
        status = get_vector(d, &frame->offset, &at, "offset", -0x1.fffffffffffffp1023);
    if (!status)
        status = get_vector(d, &frame->scale, &at, "scale", 0x1p-1074);
    return status;
}

et_status json_file_get_sides(const json_file_source *d, et_doublenet *net, const json_file_place *at)
{
    et_doublenet sides = { 0, 0 };
    et_status status = json_file_get_count(d, &sides.nx, at, "nx", 2);
    if (!status)
        status = json_file_get_count(d, &sides.ny, at, "ny", 2);
    if (!status && !et_doublenet_valid(sides))
        status = json_file_wrong(d, at, "has too many nodes");
    if (!status)
        *net = sides;
    return status;
}
