/* Fields of a line, the numbers they spell, and what to say of a field that does not. */
#include "io/cloud_parts.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

cloud_field cloud_trimmed(cloud_field f)
{
    while (f.begin < f.end && cloud_blank(*f.begin))
        f.begin++;
    while (f.begin < f.end && cloud_blank(f.end[-1]))
        f.end--;
    return f;
}

int cloud_next_field(cloud_field *f, cloud_field *rest, char separator)
{
    if (!rest->begin)
        return 0;
    if (separator != ' ') {
        char *end = memchr(rest->begin, separator, (size_t)(rest->end - rest->begin));
        *f = cloud_trimmed((cloud_field){ rest->begin, end ? end : rest->end });
        rest->begin = end ? end + 1 : NULL;
        return 1;
    }
    while (rest->begin < rest->end && cloud_blank(*rest->begin))
        rest->begin++;
    f->begin = rest->begin;
    while (rest->begin < rest->end && !cloud_blank(*rest->begin))
        rest->begin++;
    f->end = rest->begin;
    return f->begin < f->end;
}

int cloud_field_is(cloud_field f, const char *word)
{
    size_t n = strlen(word);
    return (size_t)(f.end - f.begin) == n && strncasecmp(f.begin, word, n) == 0;
}

/* A decimal number as its parts: sign, digits as an integer (`many` when they do not fit), decimal exponent. */
typedef struct { uint64_t digits; long exponent; int negative, many; char *letter; } decimal;

static char *scan_digits(decimal *d, char *p, const char *end, int after_point, int *seen)
{
    for (; p < end && *p >= '0' && *p <= '9'; p++) {
        *seen = 1;
        if (d->digits > (UINT64_MAX - 9) / 10)
            d->many = 1;
        else
            d->digits = 10 * d->digits + (uint64_t)(*p - '0');
        d->exponent -= after_point;
    }
    return p;
}

/* Whether the whole field is [+-] digits [. digits] [(e|E|d|D) [+-] digits]. */
static int scan_decimal(decimal *d, cloud_field f)
{
    char *p = f.begin;
    int seen = 0, negative = 0, exponent_seen = 0;
    long exponent = 0;
    *d = (decimal){ 0, 0, 0, 0, NULL };
    if (p < f.end && (*p == '+' || *p == '-'))
        d->negative = *p++ == '-';
    p = scan_digits(d, p, f.end, 0, &seen);
    if (p < f.end && *p == '.')
        p = scan_digits(d, p + 1, f.end, 1, &seen);
    if (!seen || p == f.end)
        return seen;
    if (*p != 'e' && *p != 'E' && *p != 'd' && *p != 'D')
        return 0;
    d->letter = p++;
    if (p < f.end && (*p == '+' || *p == '-'))
        negative = *p++ == '-';
    for (; p < f.end && *p >= '0' && *p <= '9'; p++) {
        exponent_seen = 1;
        if (exponent < 100000)
            exponent = 10 * exponent + (*p - '0');
    }
    d->exponent += negative ? -exponent : exponent;
    return exponent_seen && p == f.end;
}

/* The value of a field that strtod takes whole, correctly rounded. */
static int strtod_whole(double *value, cloud_field f)
{
    char keep = *f.end, *stop;
    *f.end = 0;
    *value = strtod(f.begin, &stop);
    *f.end = keep;
    return stop == f.end && stop > f.begin;
}

int cloud_number(double *value, cloud_field f)
{
    static const double ten[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
    decimal d;
    if (!scan_decimal(&d, f)) {
        char c = f.begin < f.end ? f.begin[f.end - f.begin > 1 && (*f.begin == '+' || *f.begin == '-')] : 0;
        return (c == '0' || c == 'i' || c == 'I' || c == 'n' || c == 'N') && strtod_whole(value, f);
    }
    /* Digits and power of ten are exact doubles: one operation, one rounding (Clinger 1990). */
    if (!d.many && d.digits <= UINT64_C(1) << 53 && d.exponent >= -22 && d.exponent <= 22) {
        double w = (double)d.digits;
        w = d.exponent < 0 ? w / ten[-d.exponent] : w * ten[d.exponent];
        *value = d.negative ? -w : w;
        return 1;
    }
    char letter = d.letter ? *d.letter : 0;
    if (d.letter)
        *d.letter = 'e';          /* Fortran's D */
    int whole = strtod_whole(value, f);
    if (d.letter)
        *d.letter = letter;
    return whole;
}

int cloud_count(size_t *count, cloud_field f)
{
    size_t n = 0;
    if (f.begin >= f.end)
        return 0;
    for (const char *p = f.begin; p < f.end; p++) {
        if (*p < '0' || *p > '9' || n > (SIZE_MAX - (size_t)(*p - '0')) / 10)
            return 0;
        n = 10 * n + (size_t)(*p - '0');
    }
    *count = n;
    return 1;
}

void cloud_show(char word[CLOUD_WORD], cloud_field f)
{
    size_t n = (size_t)(f.end - f.begin);
    size_t shown = n < CLOUD_WORD - 4 ? n : CLOUD_WORD - 4;
    for (size_t k = 0; k < shown; k++)
        word[k] = cloud_blank(f.begin[k]) ? ' ' : f.begin[k] > ' ' && f.begin[k] <= '~' ? f.begin[k] : '?';
    memcpy(word + shown, n > shown ? "..." : "", n > shown ? 4 : 1);
}

et_status cloud_unknown_word(cloud_reader *r, const char *what, cloud_field f)
{
    char word[CLOUD_WORD];
    cloud_show(word, f);
    return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: unknown %s \"%s\"", r->path, r->line, what, word);
}

et_status cloud_coordinate(cloud_reader *r, et_vec3 *p, size_t axis, cloud_field f)
{
    double value;
    char word[CLOUD_WORD];
    char letter = "xyz"[axis];
    if (f.begin >= f.end)
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %c is missing", r->path, r->line, letter);
    if (!cloud_number(&value, f)) {
        cloud_show(word, f);
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %c is not a number: \"%s\"%s", r->path, r->line, letter, word,
                              strpbrk(word, ",; ") ? " (mixed separators, or a decimal comma)" : "");
    }
    if (!isfinite(value))
        return et_status_fail(r->message, ET_EFORMAT, "%s:%zu: %c is not finite", r->path, r->line, letter);
    *cloud_axis(p, axis) = value;
    return ET_OK;
}

et_status cloud_three(cloud_reader *r, et_vec3 *p, cloud_field *rest)
{
    et_status status = ET_OK;
    for (size_t axis = 0; axis < 3 && !status; axis++) {
        cloud_field f = {NULL, NULL};
        (void)cloud_next_field(&f, rest, ' ');
        status = cloud_coordinate(r, p, axis, f);
    }
    return status;
}
