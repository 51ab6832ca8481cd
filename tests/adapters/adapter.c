/* adapter: see adapter.h. */
#include "adapter.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef enum { FINE, REFUSED, UNSUPPORTED } state;

static FILE *replies;
static char *next;                       /* the request's words that are left */
static state how;
static char why[128];
static struct { double *x; size_t n, size; } out;
static struct block { struct block *before; double x[]; } *blocks;

static void *must(void *memory)
{
    if (!memory) {
        fputs("adapter: not enough memory\n", stderr);
        exit(1);
    }
    return memory;
}

double *room(size_t n)
{
    struct block *b = must(n < (size_t)-1 / 16 ? calloc(1, sizeof *b + n * sizeof(double)) : NULL);

    b->before = blocks;
    blocks = b;
    return b->x;
}

static void set(state s, const char *reason)
{
    if (how == FINE) {
        how = s;
        snprintf(why, sizeof why, "%s", reason);
    }
}

void refuse(const char *reason)
{
    set(REFUSED, reason);
}

void unsupport(const char *reason)
{
    set(UNSUPPORTED, reason);
}

int refused(void)
{
    return how != FINE;
}

static char *word(void)
{
    char *w = next + strspn(next, " \t\r\n");

    next = w + strcspn(w, " \t\r\n");
    if (*next)
        *next++ = '\0';
    return w;
}

size_t take_count(void)
{
    char *w = word(), *end;
    const unsigned long long n = strtoull(w, &end, 10);

    if (end == w || *end)
        refuse("a count was expected");
    return (size_t)n;
}

double take_real(void)
{
    char *w = word(), *end;
    const double x = strtod(w, &end);

    if (end == w || *end)
        refuse("a real was expected");
    return x;
}

static list take(size_t each)
{
    list l = { take_count(), NULL };

    if (l.n > strlen(next))              /* not so many words can be left */
        refuse("fewer numbers than announced");
    if (refused())
        l.n = 0;
    l.x = room(each * l.n + 1);
    for (size_t k = 0; k < each * l.n; k++)
        l.x[k] = take_real();
    return l;
}

list take_reals(void)
{
    return take(1);
}

list take_points(void)
{
    return take(3);
}

size_t take_word(const char *const *words)
{
    const char *w = word();

    for (size_t k = 0; words[k]; k++)
        if (strcmp(words[k], w) == 0)
            return k;
    refuse("a word that is not known");
    return 0;
}

static size_t controls(const list *u, size_t p)
{
    return u->n > p + 1 ? u->n - p - 1 : 0;
}

curve take_curve(void)
{
    curve c;

    c.p = take_count();
    c.u = take_reals();
    c.points = take_points();
    c.weights = take_reals();
    c.n = controls(&c.u, c.p);
    return c;
}

surface take_surface(void)
{
    surface s;

    s.p = take_count();
    s.q = take_count();
    s.u = take_reals();
    s.v = take_reals();
    s.points = take_points();
    s.weights = take_reals();
    s.nu = controls(&s.u, s.p);
    s.nv = controls(&s.v, s.q);
    return s;
}

void put(double value)
{
    if (out.n == out.size) {
        out.size = 2 * out.size + 64;
        out.x = must(realloc(out.x, out.size * sizeof *out.x));
    }
    out.x[out.n++] = value;
}

void put_all(const double *values, size_t n)
{
    for (size_t k = 0; k < n; k++)
        put(values[k]);
}

void put_list(const double *values, size_t n)
{
    put((double)n);
    put_all(values, n);
}

void put_points(const double *values, size_t n)
{
    put((double)n);
    put_all(values, 3 * n);
}

int reals_good(const list *x)
{
    for (size_t k = 0; k < x->n && !refused(); k++)
        if (!isfinite(x->x[k]))
            refuse("a number is not finite");
    return !refused();
}

int knots_good(const list *u, size_t p)
{
    if (p > u->n || u->n < 2 * p + 2) {
        refuse("too few knots");
        return 0;
    }
    if (!reals_good(u))
        return 0;
    for (size_t k = 1; k < u->n; k++)
        if (u->x[k] < u->x[k - 1]) {
            refuse("knots decrease");
            return 0;
        }
    if (!(u->x[p] < u->x[u->n - p - 1]))
        refuse("an empty domain");
    return !refused();
}

/* Coordinates and weights, and their numbers. */
static int net_good(const list *points, const list *weights, size_t n)
{
    const list all = { 3 * points->n, points->x };

    if (points->n != n || (weights->n != 0 && weights->n != n)) {
        refuse("control points, weights and knots do not fit in number");
        return 0;
    }
    if (!reals_good(&all) || !reals_good(weights))
        return 0;
    for (size_t k = 0; k < weights->n; k++)
        if (!(weights->x[k] > 0))
            refuse("a weight is not positive");
    return !refused();
}

int curve_good(const curve *c)
{
    return !refused() && knots_good(&c->u, c->p) && net_good(&c->points, &c->weights, c->n);
}

int surface_good(const surface *s)
{
    return !refused() && knots_good(&s->u, s->p) && knots_good(&s->v, s->q) && net_good(&s->points, &s->weights, s->nu * s->nv);
}

int inside(const list *u, size_t p, double x)
{
    if (!(u->x[p] <= x && x <= u->x[u->n - p - 1]))
        refuse("outside the domain");
    return !refused();
}

static void forget(void)
{
    while (blocks) {
        struct block *b = blocks;
        blocks = b->before;
        free(b);
    }
    out.n = 0;
    how = FINE;
}

static void say_hello(const char *id, const char *hello, const operation *o)
{
    fprintf(replies, "%s ok protocol=1 %s ops=", id, hello);
    for (size_t k = 0; o[k].op; k++)
        fprintf(replies, "%s%s", k ? "," : "", o[k].op);
}

static void answer(const char *id, const char *op, const operation *o)
{
    while (o->op && strcmp(o->op, op) != 0)
        o++;
    if (o->op)
        o->answer();
    else
        unsupport("not offered");
    if (how == FINE && *word())
        refuse("more words than the operation has");
    if (how == FINE) {
        fprintf(replies, "%s ok", id);
        for (size_t k = 0; k < out.n; k++)
            fprintf(replies, " %a", out.x[k]);
    } else {
        fprintf(replies, "%s %s %s", id, how == REFUSED ? "refused" : "unsupported", why);
    }
}

int adapter_run(const char *hello, const operation *operations)
{
    char *line = NULL;
    size_t size = 0;

    /* What a library prints goes to standard error: not among the replies. */
    replies = fdopen(dup(STDOUT_FILENO), "w");
    if (!replies || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        return 1;
    while (getline(&line, &size, stdin) > 0) {
        next = line;
        const char *id = word(), *op = word();
        if (strcmp(op, "hello") == 0)
            say_hello(id, hello, operations);
        else
            answer(id, op, operations);
        putc('\n', replies);
        if (fflush(replies) != 0)
            break;
        forget();
    }
    free(line);
    free(out.x);
    return ferror(replies) != 0;
}
