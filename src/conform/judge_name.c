/* judge_name: what the numbers of an answer are called. */
#include "conform/judge_parts.h"
#include <stdio.h>

static const char coordinates[] = "xyz";

static const char *ending(size_t k)
{
    return k % 10 == 1 && k % 100 != 11 ? "st" : k % 10 == 2 && k % 100 != 12 ? "nd" : k % 10 == 3 && k % 100 != 13 ? "rd" : "th";
}

static void name_point(char *name, size_t size, size_t order, size_t c)
{
    if (order == 0)
        snprintf(name, size, "%c of the point", coordinates[c]);
    else
        snprintf(name, size, "%c of the %zu%s derivative", coordinates[c], order, ending(order));
}

/* S_uuv and such; of high orders by their numbers. */
static void name_partial(char *name, size_t size, size_t at, size_t c)
{
    size_t order = 0;
    char letters[16];

    while ((order + 1) * (order + 2) / 2 <= at)
        order++;
    const size_t b = at - order * (order + 1) / 2;
    if (order == 0) {
        name_point(name, size, 0, c);
    } else if (order < sizeof letters) {
        for (size_t k = 0; k < order; k++)
            letters[k] = k < order - b ? 'u' : 'v';
        letters[order] = '\0';
        snprintf(name, size, "%c of S_%s", coordinates[c], letters);
    } else {
        snprintf(name, size, "%c of the derivative %zu times in u, %zu in v", coordinates[c], order - b, b);
    }
}

/* A list of n numbers of `width` each behind its count, which is not named: 1 if number *at is of it, else *at is moved behind it. */
static int in_list(char *name, size_t size, size_t *at, size_t n, size_t width, const char *what)
{
    if (*at <= n * width) {
        const size_t i = (*at - 1) / width;
        if (width == 3)
            snprintf(name, size, "%c of %s %zu", coordinates[(*at - 1) % 3], what, i);
        else
            snprintf(name, size, "%s %zu", what, i);
        return 1;
    }
    *at -= n * width + 1;
    return 0;
}

/* Of `p u[] P{} w[]` or `p q u[] v[] P{} w[]`, want being the whole answer.  Degrees and counts are compared before, with words of their own. */
static void name_shape(char *name, size_t size, const double *want, size_t at, int surface)
{
    size_t rest = surface ? at - 2 : at - 1;

    for (int k = 0; k <= surface; k++)
        if (in_list(name, size, &rest, (size_t)want[at - rest], 1, surface ? k == 0 ? "u-knot" : "v-knot" : "knot"))
            return;
    if (!in_list(name, size, &rest, (size_t)want[at - rest], 3, "control point"))
        in_list(name, size, &rest, (size_t)want[at - rest], 1, "weight");
}

static void name_basis(char *name, size_t size, const et_request *request, size_t at)
{
    const size_t n = request->arg[1].count - request->arg[0].count - 1, k = at / n, i = at % n;

    if (k == 0)
        snprintf(name, size, "N_%zu", i);
    else
        snprintf(name, size, "the %zu%s derivative of N_%zu", k, ending(k), i);
}

static void name_list(char *name, size_t size, const et_request *request, size_t at)
{
    static const char *const counts[] = { "NON", "NOV", "NOR" }, *const node[] = { "the view", "i", "j" };

    switch (request->op) {
    case ET_OP_SPAN:
        snprintf(name, size, "the span");
        break;
    case ET_OP_MULTIPLICITY:
        snprintf(name, size, "the multiplicity");
        break;
    case ET_OP_GREVILLE:
        snprintf(name, size, "Greville point %zu", at);
        break;
    case ET_OP_KNOTS:
        snprintf(name, size, "knot %zu", at);
        break;
    case ET_OP_PARAMETERS:
        snprintf(name, size, "parameter %zu", at);
        break;
    case ET_OP_PARAMETERS_GRID: {
        const size_t nx = request->arg[1].count;
        snprintf(name, size, "parameter %zu along %c", at < nx ? at : at - nx, at < nx ? 'i' : 'j');
        break;
    }
    case ET_OP_NET_COUNTS:
        snprintf(name, size, "%s", counts[at % 3]);
        break;
    case ET_OP_NET_NODE:
        snprintf(name, size, "%s", node[at % 3]);
        break;
    case ET_OP_NET_CLASS:
        snprintf(name, size, "the class");
        break;
    case ET_OP_SURFACE_ERROR:
        snprintf(name, size, at == 0 ? "the sum of distances" : "the greatest distance");
        break;
    case ET_OP_SEAM_GAP:
        snprintf(name, size, "the gap");
        break;
    default:
        snprintf(name, size, "%c of control point %zu", coordinates[at % 3], at / 3);
    }
}

void judge_name(char name[96], const et_request *request, const double *want, size_t at)
{
    switch (request->op) {
    case ET_OP_BASIS: case ET_OP_BASIS_DERS:
        name_basis(name, 96, request, at);
        break;
    case ET_OP_CURVE_POINT: case ET_OP_CURVE_DERS:
        name_point(name, 96, at / 3, at % 3);
        break;
    case ET_OP_SURFACE_POINT: case ET_OP_SURFACE_DERS:
        name_partial(name, 96, at / 3, at % 3);
        break;
    case ET_OP_SURFACE_NORMAL:
        snprintf(name, 96, "%c of the normal", coordinates[at % 3]);
        break;
    case ET_OP_CURVE_INSERT: case ET_OP_CURVE_ELEVATE:
        name_shape(name, 96, want, at, 0);
        break;
    case ET_OP_SURFACE_INSERT: case ET_OP_SURFACE_ELEVATE:
        name_shape(name, 96, want, at, 1);
        break;
    default:
        name_list(name, 96, request, at);
    }
}
