#include "etalon/refine/objective.h"
#include "etalon/base/real.h"
#include "etalon/base/size.h"
#include "etalon/spline/basis.h"
#include "etalon/spline/knots.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A lane is one row of data in one view: bottom rows 0 .. nx-1, then the top's inner rows 1 .. nx-2, then idle lanes up to a multiple of LANES.
 * What is computed for many lanes at once stands side by side, so that the inner loops run over LANES neighbours. */
enum { LANES = 8,
       SHARE = 6 };                       /* an incremental evaluation pays while it touches at most a sixth of the data */
#define NONE SIZE_MAX

typedef struct { size_t first, end; } range;

struct et_objective {
    et_doublenet data, control;
    size_t p, q, n, nov;
    size_t lanes, width;                  /* lanes, and doubles in a row of control points, both multiples of LANES */
    /* fixed */
    double *N, *M;                        /* p+1 basis values a lane (0 where idle), q+1 a column of data */
    size_t *row, *column;                 /* first control row of a lane, first control column of a column of data */
    range *rows, *columns;                /* by control row (column): the data rows (columns) within its support */
    double *target;                       /* data: [column][coordinate][lane] */
    size_t *place;                        /* of a data class in [column][lane] */
    size_t *class;                        /* of a place: its data class - 1, or NONE */
    /* the candidate evaluated last */
    int known;
    double *net;                          /* control points: [view][row][width] */
    double *sum;                          /* rows contracted along u: [3 control column + coordinate][lane] */
    double *grid;                         /* distances: [column][lane] */
    double *distance;                     /* the same by data class */
    /* workspace */
    double *strip;                        /* LANES rows */
    size_t *changed, *dirty;              /* control classes - 1; data classes - 1 */
    unsigned char *marked;                /* by data class */
    uint64_t full, incremental;
};

/* ---- layout ---- */

static size_t view_of(const et_objective *f, size_t lane)
{
    return lane < f->data.nx || lane >= 2 * f->data.nx - 2 ? ET_BOTTOM : ET_TOP;
}

static size_t row_of(const et_objective *f, size_t lane)
{
    return lane < f->data.nx ? lane : lane - f->data.nx + 1;
}

static size_t padded(size_t n)
{
    return (n + LANES - 1) / LANES * LANES;
}

static size_t used_lanes(const et_objective *f)
{
    return 2 * f->data.nx - 2;
}

void et_objective_free(et_objective *f)
{
    if (!f) return;
    void *const arrays[] = { f->N, f->M, f->row, f->column, f->rows, f->columns, f->target, f->place, f->class, f->net, f->sum, f->grid,
                             f->distance, f->strip, f->changed, f->dirty, f->marked };
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) free(arrays[k]);
    free(f);
}

/* a b c doubles, or null. */
static double *reals(size_t a, size_t b, size_t c)
{
    size_t ab = 0, n = 0;
    if (et_size_mul(&ab, a, b) != ET_OK || et_size_mul(&n, ab, c) != ET_OK) return NULL;
    return et_size_array(n, sizeof(double));
}

static et_status allocate(et_objective *f)
{
    const size_t nx = f->data.nx, ny = f->data.ny, nu = f->control.nx, nv = f->control.ny;
    size_t places = 0;
    if (nx > (SIZE_MAX - LANES) / 2 || nv > (SIZE_MAX - LANES) / 3) return ET_ENOMEM;
    f->lanes = padded(2 * nx - 2);
    f->width = padded(3 * nv);
    if (et_size_mul(&places, ny, f->lanes) != ET_OK) return ET_ENOMEM;
    f->N = reals(f->lanes, f->p + 1, 1);
    f->M = reals(ny, f->q + 1, 1);
    f->row = et_size_array(f->lanes, sizeof(size_t));
    f->column = et_size_array(ny, sizeof(size_t));
    f->rows = et_size_array(nu, sizeof(range));
    f->columns = et_size_array(nv, sizeof(range));
    f->target = reals(places, 3, 1);
    f->place = et_size_array(f->nov, sizeof(size_t));
    f->class = et_size_array(places, sizeof(size_t));
    f->net = reals(2, nu, f->width);
    f->sum = reals(3, nv, f->lanes);
    f->grid = reals(places, 1, 1);
    f->distance = reals(f->nov, 1, 1);
    f->strip = reals(LANES, f->width, 1);
    f->changed = et_size_array(f->n / 3, sizeof(size_t));
    f->dirty = et_size_array(f->nov, sizeof(size_t));
    f->marked = et_size_array(f->nov, 1);
    return f->N && f->M && f->row && f->column && f->rows && f->columns && f->target && f->place && f->class && f->net && f->sum && f->grid
        && f->distance && f->strip && f->changed && f->dirty && f->marked ? ET_OK : ET_ENOMEM;
}

/* Basis values N and first control points at the parameters t[0..nt-1]. */
static et_status basis(double *N, size_t *first, const double *u, size_t nu, size_t p, const double *t, size_t nt)
{
    const size_t nwork = et_basis_work(p, 0);
    double *work = et_size_array(nwork, sizeof *work);
    if (!work) return ET_ENOMEM;
    for (size_t i = 0; i < nt; i++) {
        const size_t span = et_knots_span(u, nu, p, t[i]);
        et_basis_eval(N + i * (p + 1), u, nu, p, span, t[i], work, nwork);
        first[i] = span - p;
    }
    free(work);
    return ET_OK;
}

/* support[r]: the i with first[i] <= r <= first[i] + p; contiguous, for parameters do not decrease. */
static void supports(range *support, size_t nr, const size_t *first, size_t nt, size_t p)
{
    for (size_t r = 0; r < nr; r++) {
        size_t a = 0, b = nt;
        while (a < nt && first[a] + p < r) a++;
        while (b > a && first[b - 1] > r) b--;
        support[r] = (range){ a, b };
    }
}

static void lay_data(et_objective *f, const et_vec3 *data)
{
    for (size_t k = 0; k < f->data.ny * f->lanes; k++) f->class[k] = NONE;
    for (size_t lane = 0; lane < used_lanes(f); lane++) {
        const size_t view = view_of(f, lane), i = row_of(f, lane), border = view == ET_TOP ? 1 : 0;
        for (size_t j = border; j < f->data.ny - border; j++) {
            const size_t c = et_doublenet_class(f->data, view, i, j) - 1, at = j * f->lanes + lane;
            double *target = f->target + 3 * j * f->lanes + lane;
            f->place[c] = at;
            f->class[at] = c;
            target[0] = data[c].x;
            target[f->lanes] = data[c].y;
            target[2 * f->lanes] = data[c].z;
        }
    }
}

static et_status prepare(et_objective *f, const et_fit *fit, const et_vec3 *data)
{
    const et_surface *s = &fit->shell.view[ET_BOTTOM];
    const size_t nx = f->data.nx, w = f->p + 1;
    et_status status = allocate(f);
    if (status == ET_OK) status = basis(f->N, f->row, s->u, s->nu + s->p + 1, s->p, fit->s[ET_BOTTOM], nx);
    if (status == ET_OK) status = basis(f->M, f->column, s->v, s->nv + s->q + 1, s->q, fit->r[ET_BOTTOM], f->data.ny);
    if (status != ET_OK) return status;
    supports(f->rows, f->control.nx, f->row, nx, f->p);
    supports(f->columns, f->control.ny, f->column, f->data.ny, f->q);
    for (size_t lane = nx; lane < used_lanes(f); lane++) {
        f->row[lane] = f->row[row_of(f, lane)];
        memcpy(f->N + lane * w, f->N + row_of(f, lane) * w, w * sizeof *f->N);
    }
    lay_data(f, data);
    return ET_OK;
}

static int same_parameters(const et_fit *fit)
{
    for (size_t i = 0; i < fit->data.nx; i++)
        if (fit->s[ET_BOTTOM][i] != fit->s[ET_TOP][i]) return 0;
    for (size_t j = 0; j < fit->data.ny; j++)
        if (fit->r[ET_BOTTOM][j] != fit->r[ET_TOP][j]) return 0;
    return 1;
}

et_status et_objective_new(et_objective **objective, const et_fit *fit, const et_vec3 *data, size_t nov)
{
    if (!objective || !fit || !data || !et_doublenet_valid(fit->data) || nov != et_doublenet_nov(fit->data)) return ET_EINVAL;
    if (!et_shell_glued(&fit->shell) || fit->shell.view[ET_BOTTOM].weights || !same_parameters(fit)) return ET_EINVAL;
    et_objective *f = et_size_array(1, sizeof *f);
    if (!f) return ET_ENOMEM;
    f->data = fit->data;
    f->control = et_shell_net(&fit->shell);
    f->p = fit->shell.view[ET_BOTTOM].p;
    f->q = fit->shell.view[ET_BOTTOM].q;
    f->nov = nov;
    f->n = 3 * et_doublenet_nov(f->control);
    const et_status status = prepare(f, fit, data);
    if (status != ET_OK) {
        et_objective_free(f);
        return status;
    }
    *objective = f;
    return ET_OK;
}

size_t et_objective_size(const et_objective *objective)
{
    return objective->n;
}

void et_objective_counts(uint64_t *full, uint64_t *incremental, const et_objective *objective)
{
    *full = objective->full;
    *incremental = objective->incremental;
}

/* ---- full evaluation ---- */

static double *net_row(const et_objective *f, size_t view, size_t r)
{
    return f->net + (view * f->control.nx + r) * f->width;
}

/* The bottom's classes are its rows one after the other; the top's inner classes follow. */
static const double *top_row(const et_objective *f, const double *x, size_t r)
{
    return x + 3 * (f->control.nx * f->control.ny + (r - 1) * (f->control.ny - 2));
}

static void spread(et_objective *f, const double *x)
{
    const size_t nu = f->control.nx, m = 3 * f->control.ny;
    for (size_t r = 0; r < nu; r++) {
        memcpy(net_row(f, ET_BOTTOM, r), x + r * m, m * sizeof *x);
        memcpy(net_row(f, ET_TOP, r), x + r * m, m * sizeof *x);
        if (r > 0 && r < nu - 1) memcpy(net_row(f, ET_TOP, r) + 3, top_row(f, x, r), (m - 6) * sizeof *x);
    }
}

/* t[c] = sum_k N[k] P[k width + c], k = 0 .. p in this order, from the first term on (as et_surface_point): the order decides the bits. */
static void combine_any(double *restrict t, const double *restrict P, const double *restrict N, size_t p, size_t width)
{
    for (size_t c = 0; c < width; c += LANES) {
        for (size_t k = 0; k < LANES; k++) t[c + k] = N[0] * P[c + k];
        for (size_t j = 1; j <= p; j++)
            for (size_t k = 0; k < LANES; k++) t[c + k] += N[j] * P[j * width + c + k];
    }
}

static void combine_cubic(double *restrict t, const double *restrict P, const double *restrict N, size_t width)
{
    const double *restrict P1 = P + width, *restrict P2 = P1 + width, *restrict P3 = P2 + width;
    const double a = N[0], b = N[1], c = N[2], d = N[3];
    for (size_t i = 0; i < width; i += LANES)
        for (size_t k = 0; k < LANES; k++) t[i + k] = ((a * P[i + k] + b * P1[i + k]) + c * P2[i + k]) + d * P3[i + k];
}

/* LANES rows side by side become LANES neighbours in each of `count` rows.  Written out: compilers do not unroll it by themselves. */
static void transpose(double *restrict out, const double *restrict in, size_t count, size_t width, size_t lanes)
{
    const double *restrict a = in, *restrict b = a + width, *restrict c = b + width, *restrict d = c + width;
    const double *restrict e = d + width, *restrict f = e + width, *restrict g = f + width, *restrict h = g + width;
    for (size_t k = 0; k < count; k++, out += lanes) {
        out[0] = a[k];
        out[1] = b[k];
        out[2] = c[k];
        out[3] = d[k];
        out[4] = e[k];
        out[5] = f[k];
        out[6] = g[k];
        out[7] = h[k];
    }
}

static void contract_u(et_objective *f)
{
    for (size_t lane = 0; lane < f->lanes; lane += LANES) {
        for (size_t k = 0; k < LANES; k++) {
            const double *P = net_row(f, view_of(f, lane + k), f->row[lane + k]), *N = f->N + (lane + k) * (f->p + 1);
            if (f->p == 3)
                combine_cubic(f->strip + k * f->width, P, N, f->width);
            else
                combine_any(f->strip + k * f->width, P, N, f->p, f->width);
        }
        transpose(f->sum + lane, f->strip, 3 * f->control.ny, f->width, f->lanes);
    }
}

/* Distances of LANES surface points sum_l M[l] T[3 l lanes + d lanes + k] from their data D[d lanes + k], computed as et_vec3_distance does. */
static void distances_any(double *restrict out, const double *restrict T, const double *restrict M, const double *restrict D, size_t q, size_t lanes)
{
    double s[3][LANES];
    for (size_t d = 0; d < 3; d++) {
        for (size_t k = 0; k < LANES; k++) s[d][k] = M[0] * T[d * lanes + k];
        for (size_t l = 1; l <= q; l++)
            for (size_t k = 0; k < LANES; k++) s[d][k] += M[l] * T[(3 * l + d) * lanes + k];
    }
    for (size_t k = 0; k < LANES; k++) {
        const double x = D[k] - s[0][k], y = D[lanes + k] - s[1][k], z = D[2 * lanes + k] - s[2][k];
        out[k] = sqrt(x * x + y * y + z * z);
    }
}

static void distances_cubic(double *restrict out, const double *restrict T, const double *restrict M, const double *restrict D, size_t lanes)
{
    const double *restrict Tx = T, *restrict Ty = T + lanes, *restrict Tz = Ty + lanes, *restrict Dy = D + lanes, *restrict Dz = Dy + lanes;
    const double a = M[0], b = M[1], c = M[2], d = M[3];
    const size_t B = 3 * lanes, C = 2 * B, E = 3 * B;
    for (size_t k = 0; k < LANES; k++) {
        const double x = D[k] - (((a * Tx[k] + b * Tx[B + k]) + c * Tx[C + k]) + d * Tx[E + k]);
        const double y = Dy[k] - (((a * Ty[k] + b * Ty[B + k]) + c * Ty[C + k]) + d * Ty[E + k]);
        const double z = Dz[k] - (((a * Tz[k] + b * Tz[B + k]) + c * Tz[C + k]) + d * Tz[E + k]);
        out[k] = sqrt(x * x + y * y + z * z);
    }
}

static void contract_v(et_objective *f)
{
    for (size_t j = 0; j < f->data.ny; j++) {
        double *out = f->grid + j * f->lanes;
        const double *T = f->sum + 3 * f->column[j] * f->lanes, *M = f->M + j * (f->q + 1), *D = f->target + 3 * j * f->lanes;
        for (size_t lane = 0; lane < f->lanes; lane += LANES) {
            if (f->q == 3)
                distances_cubic(out + lane, T + lane, M, D + lane, f->lanes);
            else
                distances_any(out + lane, T + lane, M, D + lane, f->q, f->lanes);
        }
    }
}

static void evaluate_full(et_objective *f, const double *x)
{
    spread(f, x);
    contract_u(f);
    contract_v(f);
    for (size_t c = 0; c < f->nov; c++) f->distance[c] = f->grid[f->place[c]];
    f->known = 1;
    f->full++;
}

/* ---- incremental evaluation ---- */


/* Data classes within the support of a control class, at most. */
static size_t reach(const et_objective *f, et_index v)
{
    const range a = f->rows[v.i], b = f->columns[v.j];
    return (a.end - a.first) * (b.end - b.first) * (v.k == 1 ? 2 : 1);
}

static double *net_point(const et_objective *f, size_t view, et_index v)
{
    return net_row(f, view, v.i) + 3 * v.j;
}

/* What differs so far, and how many data classes that reaches. */
typedef struct { size_t count, cost; } difference;

/* The control classes c .. c + n - 1 stand side by side in x and at P. */
static void differ(difference *sofar, et_objective *f, const double *x, const double *P, size_t c, size_t n)
{
    if (memcmp(P, x + 3 * c, 3 * n * sizeof *x) == 0) return;
    for (size_t k = 0; k < n; k++) {
        if (memcmp(P + 3 * k, x + 3 * (c + k), 3 * sizeof *x) == 0) continue;
        f->changed[sofar->count++] = c + k;
        sofar->cost += reach(f, et_doublenet_index(f->control, c + k + 1));
    }
}

/* The control classes in which x differs from the candidate before: their number, or NONE when they reach so far that a full evaluation is
 * cheaper. */
static size_t differences(et_objective *f, const double *x)
{
    const size_t nu = f->control.nx, nv = f->control.ny, limit = f->nov / SHARE;
    difference sofar = { 0, 0 };
    for (size_t r = 0; r < nu && sofar.cost <= limit; r++) {
        differ(&sofar, f, x, net_row(f, ET_BOTTOM, r), r * nv, nv);
        if (r > 0 && r < nu - 1) differ(&sofar, f, x, net_row(f, ET_TOP, r) + 3, nu * nv + (r - 1) * (nv - 2), nv - 2);
    }
    return sofar.cost <= limit ? sofar.count : NONE;
}

static void take(et_objective *f, const double *x, size_t c)
{
    const et_index v = et_doublenet_index(f->control, c + 1);
    if (v.k != 2) memcpy(net_point(f, ET_BOTTOM, v), x + 3 * c, 3 * sizeof *x);
    if (v.k != 0) memcpy(net_point(f, ET_TOP, v), x + 3 * c, 3 * sizeof *x);
}

/* The sums and the dirty data classes of one lane under control column j. */
static size_t renew_lane(et_objective *f, size_t lane, size_t j, size_t ndirty)
{
    const double *P = net_row(f, view_of(f, lane), f->row[lane]) + 3 * j, *N = f->N + lane * (f->p + 1);
    for (size_t d = 0; d < 3; d++) {
        double t = N[0] * P[d];
        for (size_t k = 1; k <= f->p; k++) t += N[k] * P[k * f->width + d];
        f->sum[(3 * j + d) * f->lanes + lane] = t;
    }
    for (size_t k = f->columns[j].first; k < f->columns[j].end; k++) {
        const size_t c = f->class[k * f->lanes + lane];
        if (c == NONE || f->marked[c]) continue;
        f->marked[c] = 1;
        f->dirty[ndirty++] = c;
    }
    return ndirty;
}

static size_t renew(et_objective *f, size_t c, size_t ndirty)
{
    const et_index v = et_doublenet_index(f->control, c + 1);
    const range a = f->rows[v.i];
    for (size_t i = a.first; i < a.end; i++) {
        if (v.k != 2) ndirty = renew_lane(f, i, v.j, ndirty);
        if (v.k != 0 && i > 0 && i < f->data.nx - 1) ndirty = renew_lane(f, f->data.nx + i - 1, v.j, ndirty);
    }
    return ndirty;
}

static double distance_at(const et_objective *f, size_t place)
{
    const size_t lane = place % f->lanes, j = place / f->lanes;
    const double *T = f->sum + 3 * f->column[j] * f->lanes + lane, *M = f->M + j * (f->q + 1), *D = f->target + 3 * j * f->lanes + lane;
    et_vec3 S = { M[0] * T[0], M[0] * T[f->lanes], M[0] * T[2 * f->lanes] };
    for (size_t l = 1; l <= f->q; l++) {
        T += 3 * f->lanes;
        S.x += M[l] * T[0];
        S.y += M[l] * T[f->lanes];
        S.z += M[l] * T[2 * f->lanes];
    }
    return et_vec3_distance((et_vec3){ D[0], D[f->lanes], D[2 * f->lanes] }, S);
}

static void evaluate_changed(et_objective *f, const double *x, size_t nchanged)
{
    size_t ndirty = 0;
    for (size_t k = 0; k < nchanged; k++) take(f, x, f->changed[k]);
    for (size_t k = 0; k < nchanged; k++) ndirty = renew(f, f->changed[k], ndirty);
    for (size_t k = 0; k < ndirty; k++) {
        const size_t c = f->dirty[k];
        f->distance[c] = distance_at(f, f->place[c]);
        f->marked[c] = 0;
    }
    f->incremental++;
}

et_status et_objective_eval(double *value, const double *x, size_t n, void *objective)
{
    et_objective *f = objective;
    if (!value || !x || !f || n != f->n) return ET_EINVAL;
    const size_t nchanged = f->known ? differences(f, x) : NONE;
    if (nchanged == NONE)
        evaluate_full(f, x);
    else
        evaluate_changed(f, x, nchanged);
    *value = et_real_sum(f->distance, f->nov);
    return ET_OK;
}
