/* golden: reading the rows, and comparing as their class says. */
#include "rows.h"
#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t faults;                    /* of the row under test */
static bool quiet;
static row_judge judging;

static bool tell(const row *r, const char *what, size_t i)
{
    if (!quiet)
        printf("  %s:%zu: %s %zu\n", r->file, r->line, what, i);
    faults++;
    return false;
}

static bool number(const char *text, double *x)
{
    char *stop;

    *x = strtod(text, &stop);
    return stop != text && *stop == '\0';
}

double row_real(const row *r, size_t i)
{
    double x = 0;

    if (i >= r->nargs || !number(r->arg[i], &x))
        tell(r, "missing or malformed real argument", i);
    return x;
}

static bool count(const char *text, size_t *n)
{
    char *stop;
    const unsigned long long v = strtoull(text, &stop, 0);

    *n = (size_t)v;
    return isdigit((unsigned char)text[0]) && *stop == '\0' && v <= SIZE_MAX;
}

size_t row_size(const row *r, size_t i)
{
    size_t n = 0;

    if (i >= r->nargs || !count(r->arg[i], &n))
        tell(r, "missing or malformed count, argument", i);
    return n;
}

/* Doubles in their order as integers: neighbours differ by one, both zeros are equal. */
static int64_t rank(double x)
{
    int64_t b;

    memcpy(&b, &x, sizeof b);
    return b < 0 ? INT64_MIN - b : b;
}

static double ulps(double a, double b)
{
    const int64_t m = rank(a), n = rank(b);

    return (double)(m > n ? (uint64_t)m - (uint64_t)n : (uint64_t)n - (uint64_t)m);
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* Both of them bound the distance. */
static bool is_distance(const row *r)
{
    return strcmp(r->class, "abs") == 0 || strcmp(r->class, "gap") == 0;
}

static bool is_residual(const row *r)
{
    return strcmp(r->class, "residual") == 0;
}

static bool agrees(const row *r, double got, double want)
{
    if (is_residual(r))
        return fabs(got) <= r->tolerance;
    if (same_bits(got, want))
        return true;
    if (judging == ROW_TRUTH)
        return got == 0 && want == 0;        /* an exact zero has no sign */
    if (isnan(got) || isnan(want))
        return false;
    if (strcmp(r->class, "ulp") == 0)
        return ulps(got, want) <= r->tolerance;
    if (is_distance(r))
        return fabs(got - want) <= r->tolerance;
    return false;
}

bool row_is(const row *r, size_t i, double got)
{
    double want = 0;

    if (!is_residual(r) && (i >= r->nwant || !number(r->want[i], &want)))
        return tell(r, "missing or malformed wanted value", i);
    if (agrees(r, got, want))
        return true;
    if (!quiet)
        printf("  %s:%zu: wanted value %zu is %a (%.17g), got %a (%.17g), %.0f ulps apart\n", r->file, r->line, i, want, want, got, got,
               isnan(got) || isnan(want) ? 0.0 : ulps(got, want));
    faults++;
    return false;
}

bool row_is_size(const row *r, size_t i, size_t got)
{
    size_t want = 0;

    if (i >= r->nwant || !count(r->want[i], &want))
        return tell(r, "missing or malformed wanted count", i);
    if (got == want)
        return true;
    if (!quiet)
        printf("  %s:%zu: wanted count %zu is %zu, got %zu\n", r->file, r->line, i, want, got);
    faults++;
    return false;
}

static char *cut(char **rest, const char *at)
{
    char *here = *rest;

    here += strspn(here, at[0] == '\t' ? "" : at);
    *rest = here + strcspn(here, at);
    if (**rest != '\0')
        *(*rest)++ = '\0';
    return here;
}

static bool words(char *text, char ***list, size_t *n)
{
    *n = 0;
    *list = malloc((strlen(text) / 2 + 1) * sizeof **list);
    if (!*list)
        return false;
    while (*(text += strspn(text, " ")) != '\0')
        (*list)[(*n)++] = cut(&text, " ");
    return true;
}

static bool class_of(row *r)
{
    char *rest = r->class;
    const char *kind = cut(&rest, " ");
    const bool takes = strcmp(kind, "ulp") == 0 || strcmp(kind, "abs") == 0 || strcmp(kind, "gap") == 0
        || strcmp(kind, "residual") == 0;

    r->tolerance = 0;
    if (!takes)
        return (strcmp(kind, "exact") == 0 || strcmp(kind, "bits") == 0) && *rest == '\0';
    return number(rest, &r->tolerance) && r->tolerance >= 0;
}

/* line is cut into pieces in place. */
static bool parse(row *r, char *line)
{
    char *rest = line, *args, *want;
    size_t tabs = 0;

    r->arg = r->want = NULL;
    for (const char *c = line; *c; c++)
        tabs += *c == '\t';
    line[strcspn(line, "\r\n")] = '\0';
    r->function = cut(&rest, "\t");
    r->class = cut(&rest, "\t");
    r->reason = cut(&rest, "\t");
    args = cut(&rest, "\t");
    want = cut(&rest, "\t");
    return words(args, &r->arg, &r->nargs) && words(want, &r->want, &r->nwant) && tabs == 4 && class_of(r);
}

static const golden *find(const char *name)
{
    for (const golden *t = judging == ROW_TRUTH ? truths : goldens; t->name; t++)
        if (strcmp(t->name, name) == 0)
            return t;
    return NULL;
}

static verdict compare(const row *r, const golden *t)
{
    verdict v;

    faults = 0;
    v = t->run(r);
    return v == PASS && faults > 0 ? FAIL : v;
}

static void release(row *r)
{
    free(r->arg);
    free(r->want);
}

/* A tolerant row must be known to somebody who is not; but an optimum has no exact computation, only its certificate. */
static verdict unknown(const row *r)
{
    return judging == ROW_TRUTH && (r->tolerance <= 0 || is_residual(r) || strcmp(r->class, "gap") == 0) ? SKIP : FAIL;
}

verdict row_run(const char *file, size_t lineno, char *line, row_judge judge, char what[ROW_WHAT])
{
    row r = { .file = file, .line = lineno };
    judging = judge;
    const bool fine = parse(&r, line);
    const golden *t = find(r.function);
    const verdict v = !fine ? FAIL : t ? compare(&r, t) : unknown(&r);

    snprintf(what, ROW_WHAT, "%s (%s)%s", r.function, r.reason,
             !fine ? ": malformed row" : t ? "" : judge == ROW_TRUTH ? ": no exact function computes it" : ": no such golden check");
    release(&r);
    return v;
}

/* The nearest wanted value that the class must not let through. */
static void alter(const row *r, const char *text, char altered[ROW_ALTERED])
{
    double x = 0;
    const bool is_number = number(text, &x), loose = judging == ROW_GOLDEN && r->tolerance > 0;

    if (!is_number || isnan(x))
        snprintf(altered, ROW_ALTERED, "%s", is_number ? "0" : "?");
    else if (!loose && text[strspn(text, "0123456789")] == '\0') {
        snprintf(altered, ROW_ALTERED, "%s", text);
        altered[strlen(altered) - 1] ^= 1;       /* the last digit */
    }
    else if (loose && is_distance(r))
        snprintf(altered, ROW_ALTERED, "%a", nextafter(x + 3 * r->tolerance, INFINITY));
    else {
        for (double k = loose ? 2 * r->tolerance + 1 : 1; k > 0; k--)
            x = nextafter(x, isinf(x) ? 0 : x > 0 ? INFINITY : -INFINITY);
        snprintf(altered, ROW_ALTERED, "%a", x);
    }
}

size_t row_bite(const char *file, size_t lineno, char *line, row_judge judge, size_t *missed)
{
    row r = { .file = file, .line = lineno };
    judging = judge;
    const bool fine = parse(&r, line);
    const golden *t = find(r.function);
    const size_t n = fine && t && !is_residual(&r) ? r.nwant : 0;
    char altered[ROW_ALTERED];

    for (size_t i = 0; i < n; i++) {
        char *was = r.want[i];
        alter(&r, was, altered);
        r.want[i] = altered;
        quiet = true;
        if (compare(&r, t) == PASS) {
            printf("  %s:%zu: %s does not notice wanted value %zu altered from %s to %s\n", file, lineno, r.function, i, was, altered);
            ++*missed;
        }
        quiet = false;
        r.want[i] = was;
    }
    release(&r);
    return n;
}
