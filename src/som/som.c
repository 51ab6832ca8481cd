#include "etalon/som/som.h"
#include "som/winner.h"

enum { STEPS_PER_REPORT = 1000 };

/* Everything one step needs.  Squared distances within the net are small integers, so the Gaussian is tabulated a step at a time by
 * squared distance, for those that occur in this net and can come within the radius. */
typedef struct {
    winner_space w;
    tally score;
    et_doublenet net;
    et_vec3 input;                  /* of this step ... */
    et_index winner;                /* ... and who won it */
    double alpha0, sigma0, tau;     /* tau == 0: alpha and sigma stay as they are */
    double *factor;                 /* by squared distance, below limit */
    size_t *dist2;                  /* the squared distances that occur, ascending */
    size_t limit, distinct, within; /* within: how many of dist2 are below sigma^2 now */
    size_t *reach[2];               /* reach[K][I]: how many J < ny have I^2 + J^2 + K^2 below sigma^2 ... */
    size_t rows[2];                 /* ... for I < rows[K], beyond which none has */
} training;

et_som_options et_som_defaults(void)
{
    const et_som_options options = {30000, 0.9, 0};

    return options;
}

void et_som_start(et_vec3 *weights, size_t nov, et_rng *rng)
{
    for (size_t c = 0; c < nov; c++) {
        weights[c].x = et_rng_uniform(rng);
        weights[c].y = et_rng_uniform(rng);
        weights[c].z = et_rng_uniform(rng);
    }
}

static void training_free(training *s)
{
    winner_free(&s->w);
    tally_free(&s->score);
    free(s->factor);
    free(s->dist2);
    free(s->reach[0]);
}

/* One more than the greatest squared distance that can matter: within the net, and below sigma0^2. */
static et_status limit_of(size_t *limit, et_doublenet net, double sigma0)
{
    const double s2 = sigma0 * sigma0;
    size_t ii, jj;

    if (et_size_mul(&ii, net.nx - 1, net.nx - 1) || et_size_mul(&jj, net.ny - 1, net.ny - 1) || ii > SIZE_MAX / 4 || jj > SIZE_MAX / 4)
        return ET_ENOMEM;
    *limit = ii + jj + 2;
    if (s2 < (double)*limit)
        *limit = (size_t)ceil(s2);
    return ET_OK;
}

/* Marks, then lists, the squared distances I^2 + J^2 + K^2 below the limit with I < nx, J < ny, K < 2. */
static et_status list_distances(training *s)
{
    size_t n = 0;

    for (size_t i = 0; i < s->net.nx && i * i < s->limit; i++)
        for (size_t j = 0; j < s->net.ny && i * i + j * j < s->limit; j++) {
            s->factor[i * i + j * j] = 1;
            if (i * i + j * j + 1 < s->limit)
                s->factor[i * i + j * j + 1] = 1;
        }
    for (size_t q = 0; q < s->limit; q++)
        s->distinct += s->factor[q] > 0;
    s->dist2 = et_size_array(s->distinct, sizeof *s->dist2);
    if (!s->dist2)
        return ET_ENOMEM;
    for (size_t q = 0; q < s->limit; q++)
        if (s->factor[q] > 0)
            s->dist2[n++] = q;
    return ET_OK;
}

static et_status training_new(training *s, et_doublenet net, const et_som_options *options)
{
    const training none = {0};
    const double side = (double)(net.nx < net.ny ? net.nx : net.ny);
    et_status status;

    *s = none;
    s->net = net;
    s->alpha0 = options->alpha0;
    s->sigma0 = options->sigma0 > 0 ? options->sigma0 : side / 2;
    s->sigma0 = s->sigma0 > 1 ? s->sigma0 : 1; /* no radius up to 1 reaches beyond the winner */
    s->tau = s->sigma0 > 1 ? (double)options->iterations / et_real_log(s->sigma0) : 0;
    status = limit_of(&s->limit, net, s->sigma0);
    if (status)
        return status;
    status = winner_new(&s->w, net);
    if (status)
        return status;
    status = tally_new(&s->score, options->iterations);
    if (status) {
        winner_free(&s->w);
        return status;
    }
    s->factor = et_size_array(s->limit, sizeof *s->factor);
    s->reach[0] = et_size_array(net.nx, 2 * sizeof *s->reach[0]);
    s->reach[1] = s->reach[0] ? s->reach[0] + net.nx : NULL;
    status = s->factor && s->reach[0] ? list_distances(s) : ET_ENOMEM;
    if (status)
        training_free(s);
    return status;
}

/* How far the radius reaches when it takes in squared distances up to `greatest`. */
static void set_reach(training *s, size_t greatest)
{
    for (size_t k = 0; k < 2; k++) {
        size_t i, j = s->net.ny;

        for (i = 0; i < s->net.nx; i++) {
            while (j > 0 && i * i + (j - 1) * (j - 1) + k > greatest)
                j--;
            if (j == 0)
                break;
            s->reach[k][i] = j;
        }
        s->rows[k] = i;
    }
}

/* alpha(t), sigma(t), and from them the table of factors and the reaches. */
static void decay(training *s, size_t t)
{
    const double shrink = s->tau > 0 ? et_real_exp(-((double)t / s->tau)) : 1;
    const double alpha = s->alpha0 * shrink, sigma = s->sigma0 * shrink, s2 = sigma * sigma;
    size_t within = 0;

    while (within < s->distinct && (double)s->dist2[within] < s2) {
        s->factor[s->dist2[within]] = alpha * et_real_exp(-((double)s->dist2[within] / (2 * s2)));
        within++;
    }
    if (within != s->within)
        set_reach(s, s->dist2[within - 1]); /* 0 is always within */
    s->within = within;
}

/* Move towards the input the classes of row i on one level with j in from .. to; class j stands at array index at + j. */
static void pull(training *s, size_t i, size_t level, size_t from, size_t to, size_t at)
{
    const size_t row = s->winner.i, column = s->winner.j, away = i < row ? row - i : i - row;
    const size_t k = level < s->winner.k ? s->winner.k - level : level - s->winner.k, reach = away < s->rows[k] ? s->reach[k][away] : 0;
    const double px = s->input.x, py = s->input.y, pz = s->input.z, *factor = s->factor + away * away + k;
    double *restrict x = s->w.x + at, *restrict y = s->w.y + at, *restrict z = s->w.z + at;

    if (reach == 0)
        return;
    if (column + 1 > from + reach)
        from = column + 1 - reach;
    if (column + reach - 1 < to)
        to = column + reach - 1;
    for (size_t j = from; j <= to; j++) {
        const size_t across = j < column ? column - j : j - column;
        const double f = factor[across * across];

        x[j] += f * (px - x[j]);
        y[j] += f * (py - y[j]);
        z[j] += f * (pz - z[j]);
    }
}

/* Every class within the radius, but none of the opposite view's interior (K = 2). */
static void pull_all(training *s)
{
    const size_t nx = s->net.nx, ny = s->net.ny, row = s->winner.i, column = s->winner.j, reach = s->rows[0]; /* rows[1] <= rows[0] */
    const size_t first = row + 1 > reach ? row + 1 - reach : 0, last = row + reach - 1 < nx - 1 ? row + reach - 1 : nx - 1;
    const size_t widest = s->reach[0][0];

    for (size_t i = first; i <= last; i++) {
        if (i == 0 || i == nx - 1) {
            pull(s, i, 1, 0, ny - 1, i * ny);
            continue;
        }
        if (column < widest)
            pull(s, i, 1, 0, 0, i * ny);
        if (ny - 1 - column < widest)
            pull(s, i, 1, ny - 1, ny - 1, i * ny);
        if (s->winner.k != 2)
            pull(s, i, 0, 1, ny - 2, i * ny);
        if (s->winner.k != 0)
            pull(s, i, 2, 1, ny - 2, nx * ny + (i - 1) * (ny - 2) - 1);
    }
}

static void unload(et_vec3 *weights, const winner_space *w)
{
    for (size_t c = 0; c < w->classes; c++) {
        weights[c].x = w->x[c];
        weights[c].y = w->y[c];
        weights[c].z = w->z[c];
    }
}

static int valid_options(const et_som_options *o)
{
    return o->iterations > 0 && o->alpha0 > 0 && o->alpha0 <= 1 && o->sigma0 >= 0 && isfinite(o->sigma0);
}

et_status et_som_train(et_vec3 *weights, size_t nov, et_som_quality *quality, et_doublenet net, const et_vec3 *cloud, size_t n,
                       const et_som_options *options, et_rng *rng, const et_task *task)
{
    training s;
    et_status status;

    if (!et_doublenet_valid(net) || nov != et_doublenet_nov(net) || n == 0 || !valid_options(options))
        return ET_EINVAL;
    if (!winner_bounded(weights, nov) || !winner_bounded(cloud, n))
        return ET_EINVAL;
    status = training_new(&s, net, options);
    if (status)
        return status;
    winner_load(&s.w, weights);
    for (size_t t = 1; t <= options->iterations && status == ET_OK; t++) {
        s.input = cloud[et_rng_index(rng, n)];
        const winner_pair pair = winner_find(&s.w, s.input);
        s.winner = s.w.index[pair.first];
        tally_add(&s.score, &s.w, pair);
        decay(&s, t);
        pull_all(&s);
        if (t % STEPS_PER_REPORT == 0 && t < options->iterations)
            status = et_task_step(task, t, options->iterations);
    }
    unload(weights, &s.w);
    *quality = tally_quality(&s.score);
    training_free(&s);
    return status;
}
