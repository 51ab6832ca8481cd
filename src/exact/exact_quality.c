/* exact_quality: winners by exactly compared distances, errors correctly rounded. */
#include "etalon/base/size.h"
#include "exact/exact_radical_parts.h"
#include <math.h>
#include <stdlib.h>

typedef struct {
    const et_vec3 *weights;
    size_t nov;
    exact_net w;       /* weights in a unit that is the points', too */
    fmpz *p;           /* the point, homogeneous */
    double *d;         /* squared distances to a point, as computed */
    size_t *candidate; /* classes - 1 */
    fmpz *square;      /* their squared distances, exact */
    fmpz *winner;      /* of each point: its squared distance to the winner */
} race;

static int bounded(const et_vec3 *points, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!(fabs(points[i].x) <= 0x1p500 && fabs(points[i].y) <= 0x1p500 && fabs(points[i].z) <= 0x1p500))
            return 0;
    return 1;
}

/* A computed square d2 of a distance differs from the exact one by at most 5.1u d2 + 2^-1072: the differences' errors count twice, a square's and two
 * additions' once, each u, and each square may underflow by 2^-1075.  So a class whose exact square is not above that of the class computed as `d2`
 * has been computed as at most d2 (1 + 11u) + 2^-1070; here the product and the sum are rounded, too. */
static double reach(double d2)
{
    return d2 * 0x1.0000000000010p0 + 0x1p-1068;
}

/* Computed squares to all classes; returns the second least of them. */
static double square_all(race *r, et_vec3 p)
{
    double first = INFINITY, second = INFINITY;

    for (size_t c = 0; c < r->nov; c++) {
        const et_vec3 w = r->weights[c];
        const double x = w.x - p.x, y = w.y - p.y, z = w.z - p.z, d2 = x * x + y * y + z * z;
        r->d[c] = d2;
        second = d2 < first ? first : d2 < second ? d2 : second;
        first = d2 < first ? d2 : first;
    }
    return second;
}

/* Put candidate n, of class c + 1, among those before it, which are the two or fewer nearest; equal squares leave the lower class in front. */
static size_t compete(race *r, size_t n, size_t c)
{
    size_t at = n < 2 ? n : 2;
    fmpz_t one;

    fmpz_init(one);
    exact_gap(r->square + at, one, r->w.H + EXACT_COMPONENTS * c, 0, r->p, 0);
    fmpz_clear(one);
    r->candidate[at] = c;
    for (; at > 0 && fmpz_cmp(r->square + at, r->square + at - 1) < 0; at--) {
        const size_t other = r->candidate[at - 1];
        fmpz_swap(r->square + at, r->square + at - 1);
        r->candidate[at - 1] = r->candidate[at];
        r->candidate[at] = other;
    }
    return n + 1;
}

/* The two nearest classes of a point: whoever may be among them competes in exact numbers. */
static void nearest(race *r, et_vec3 p)
{
    const double far = reach(square_all(r, p));
    size_t n = 0;

    exact_integer(r->p, p.x, r->w.e);
    exact_integer(r->p + 1, p.y, r->w.e);
    exact_integer(r->p + 2, p.z, r->w.e);
    for (size_t c = 0; c < r->nov; c++)
        if (r->d[c] <= far)
            n = compete(r, n, c);
}

/* The greatest and the least of the winners' squares. */
static void extremes(et_som_quality *q, const race *r, size_t n)
{
    const fmpz *least = r->winner, *greatest = r->winner;
    fmpz_t one;

    fmpz_init_set_ui(one, 1);
    for (size_t k = 1; k < n; k++) {
        least = fmpz_cmp(r->winner + k, least) < 0 ? r->winner + k : least;
        greatest = fmpz_cmp(r->winner + k, greatest) > 0 ? r->winner + k : greatest;
    }
    q->min_error = exact_root(least, one, r->w.e);
    q->max_error = exact_root(greatest, one, r->w.e);
    fmpz_clear(one);
}

static double share(size_t part, size_t n)
{
    double x;
    fmpq_t q;

    fmpq_init(q);
    fmpz_set_ui(fmpq_numref(q), (ulong)part);
    fmpz_set_ui(fmpq_denref(q), (ulong)n);
    fmpq_canonicalise(q);
    x = exact_round(q);
    fmpq_clear(q);
    return x;
}

static void run(et_som_quality *quality, race *r, et_doublenet net, const et_vec3 *cloud, size_t n, size_t *bits)
{
    et_som_quality q = {0, 0, 0, 0, n};
    size_t apart = 0;
    slong e;

    exact_net_init(&r->w, r->weights, NULL, r->nov, 1, 1);
    e = r->w.e;
    for (size_t k = 0; k < n; k++)
        e = exact_place(exact_place(exact_place(e, cloud[k].x), cloud[k].y), cloud[k].z);
    exact_net_align(&r->w, e);
    r->winner = _fmpz_vec_init((slong)n);
    for (size_t k = 0; k < n; k++) {
        nearest(r, cloud[k]);
        fmpz_swap(r->winner + k, r->square);
        apart += !et_doublenet_adjacent(et_doublenet_index(net, r->candidate[0] + 1), et_doublenet_index(net, r->candidate[1] + 1));
    }
    q.qe = exact_root_sum(r->winner, NULL, n, e, n, bits);
    q.te = share(apart, n);
    extremes(&q, r, n);
    *quality = q;
    _fmpz_vec_clear(r->winner, (slong)n);
    exact_net_clear(&r->w);
}

et_status et_exact_quality_of(et_som_quality *quality, const et_vec3 *weights, size_t nov, et_doublenet net, const et_vec3 *cloud, size_t n,
                              size_t *bits)
{
    size_t prec = exact_first_bits(bits), candidate[3];
    race r = {.weights = weights, .nov = nov, .candidate = candidate};

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net) || n == 0 || !bounded(weights, nov) || !bounded(cloud, n))
        return ET_EINVAL;
    r.d = et_size_array(nov, sizeof *r.d);
    if (r.d == NULL)
        return ET_ENOMEM;
    r.square = _fmpz_vec_init(3);
    r.p = _fmpz_vec_init(EXACT_COMPONENTS);
    fmpz_one(r.p + 3);
    run(quality, &r, net, cloud, n, &prec);
    if (bits != NULL)
        *bits = prec;
    _fmpz_vec_clear(r.square, 3);
    _fmpz_vec_clear(r.p, EXACT_COMPONENTS);
    free(r.d);
    return ET_OK;
}
