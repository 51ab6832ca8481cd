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
    /*@ loop invariant place: c <= nov;
        loop invariant cube:  \forall integer a; 0 <= a < c ==>
                                  0 <= weights[a].x < 1 && 0 <= weights[a].y < 1 && 0 <= weights[a].z < 1;
        loop assigns c, weights[0 .. nov - 1], *rng;
        loop variant nov - c;
    */
    for (size_t c = 0; c < nov; c++) {
        weights[c].x = et_rng_uniform(rng);
        weights[c].y = et_rng_uniform(rng);
        weights[c].z = et_rng_uniform(rng);
    }
}

/*@ predicate training_net(training *s) = \valid(s) && et_net_ok(s->net.nx, s->net.ny) && s->w.classes == NOV(s->net.nx, s->net.ny)
        && (s->net.nx - 1)*(s->net.nx - 1) <= SIZE_MAX / 4 && (s->net.ny - 1)*(s->net.ny - 1) <= SIZE_MAX / 4;

    predicate training_tables(training *s) = 1 <= s->limit && 1 <= s->distinct <= s->limit
        && \valid(s->factor + (0 .. s->limit - 1)) && \valid(s->dist2 + (0 .. s->distinct - 1))
        && \valid(s->reach[0] + (0 .. s->net.nx - 1)) && \valid(s->reach[1] + (0 .. s->net.nx - 1));

    predicate training_apart(training *s) = \separated(s, s->factor + (0 .. s->limit - 1), s->dist2 + (0 .. s->distinct - 1),
        s->reach[0] + (0 .. s->net.nx - 1), s->reach[1] + (0 .. s->net.nx - 1));

    predicate training_listed(training *s) = s->dist2[0] == 0 && (\forall integer q; 0 <= q < s->distinct ==> s->dist2[q] < s->limit);

    predicate training_level(training *s, integer k, integer rows) = \forall integer i; 0 <= i < rows ==>
        1 <= s->reach[k][i] <= s->net.ny && i*i + (s->reach[k][i] - 1)*(s->reach[k][i] - 1) + k < s->limit;

    predicate training_reaches(training *s) = 1 <= s->rows[0] <= s->net.nx && s->rows[1] <= s->net.nx
        && training_level(s, 0, s->rows[0]) && training_level(s, 1, s->rows[1]);
*/

/*@ predicate training_space(training *s) =
        \valid(s->w.x + (0 .. s->w.padded - 1)) && \valid(s->w.y + (0 .. s->w.padded - 1)) && \valid(s->w.z + (0 .. s->w.padded - 1))
        && \separated(s, s->factor + (0 .. s->limit - 1), s->w.x + (0 .. s->w.padded - 1), s->w.y + (0 .. s->w.padded - 1),
                         s->w.z + (0 .. s->w.padded - 1)) && s->w.classes <= s->w.padded;
*/

/*@ predicate training_start(training *s, integer iterations) = training_net(s) && training_tables(s) && training_apart(s) && training_listed(s)
        && training_space(s) && winner_arrays(&s->w) && winner_indexed(&s->w, s->net.nx, s->net.ny) && tally_arrays(&s->score, iterations)
        && s->within == 0 && s->score.count == 0;

    predicate training_blocks(training *s, integer iterations) =
        \separated(s, s->factor + (0 .. s->limit - 1), s->dist2 + (0 .. s->distinct - 1), s->reach[0] + (0 .. s->net.nx - 1),
            s->reach[1] + (0 .. s->net.nx - 1), s->w.x + (0 .. s->w.padded - 1), s->w.y + (0 .. s->w.padded - 1),
            s->w.z + (0 .. s->w.padded - 1), s->w.d + (0 .. s->w.padded - 1), s->w.index + (0 .. s->w.classes - 1),
            s->score.error + (0 .. TALLY_BLOCK - 1), s->score.block + (0 .. iterations / TALLY_BLOCK));
*/

/*@ requires training: \valid_read(s);
    assigns  \nothing;
*/
static void training_free(training *s)
{
    winner_free(&s->w);
    tally_free(&s->score);
    free(s->factor);
    free(s->dist2);
    free(s->reach[0]);
}

/* One more than the greatest squared distance that can matter: within the net, and below sigma0^2. */
/*@ requires net:    et_net_ok(net.nx, net.ny) && \valid(limit);
    assigns  *limit;
    ensures  range:  \result == ET_OK || \result == ET_ENOMEM;
    ensures  fits:   \result == ET_OK ==> 1 <= *limit && (net.nx - 1)*(net.nx - 1) <= SIZE_MAX / 4 && (net.ny - 1)*(net.ny - 1) <= SIZE_MAX / 4;
*/
static et_status limit_of(size_t *limit, et_doublenet net, double sigma0)
{
    const double s2 = sigma0 * sigma0;
    size_t ii, jj;

    if (et_size_mul(&ii, net.nx - 1, net.nx - 1) || et_size_mul(&jj, net.ny - 1, net.ny - 1) || ii > SIZE_MAX / 4 || jj > SIZE_MAX / 4)
        return ET_ENOMEM;
    *limit = ii + jj + 2;
    //@ assert double: \is_finite((double)*limit) && (double)*limit <= 0x1p63;
    if (s2 < (double)*limit)
        *limit = s2 > 1 ? (size_t)ceil(s2) : 1;
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

/*@ requires net:      et_net_ok(net.nx, net.ny) && \valid(s);
    requires options:  \valid_read(options) && et_som_options_ok(*options) && \separated(s, options);
    assigns  *s;
    ensures  range:    \result == ET_OK || \result == ET_ENOMEM;
    ensures  made:     \result == ET_OK ==> training_start(s, options->iterations) && training_blocks(s, options->iterations);
    ensures  net:      \result == ET_OK ==> s->net == net;
*/
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
/*@ requires training: training_net(s) && training_tables(s) && training_apart(s);
    requires within:   greatest < s->limit;
    assigns  s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1], s->rows[0 .. 1];
    ensures  reaches:  training_reaches(s);
*/
static void set_reach(training *s, size_t greatest)
{
    /*@ loop invariant place:  k <= 2;
        loop invariant bottom: k >= 1 ==> 1 <= s->rows[0] <= s->net.nx && training_level(s, 0, s->rows[0]);
        loop invariant next:   k >= 2 ==> s->rows[1] <= s->net.nx && training_level(s, 1, s->rows[1]);
        loop assigns k, s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1], s->rows[0 .. 1];
        loop variant 2 - k;
    */
    for (size_t k = 0; k < 2; k++) {
        size_t i, j = s->net.ny;

        //@ assert level: k == 0 || k == 1;
        /*@ loop invariant place:  i <= s->net.nx && j <= s->net.ny && (i == 0 || k >= 1 || 1 <= j);
            loop invariant bottom: k == 0 ==> training_level(s, 0, i);
            loop invariant next:   k == 1 ==> training_level(s, 1, i);
            loop invariant before: k == 1 ==> 1 <= s->rows[0] <= s->net.nx && training_level(s, 0, s->rows[0]);
            loop invariant frame:  s->reach[0] == \at(s->reach[0], Pre) && s->reach[1] == \at(s->reach[1], Pre) && s->net == \at(s->net, Pre)
                                       && s->limit == \at(s->limit, Pre);
            loop assigns i, j, s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1];
            loop variant s->net.nx - i;
        */
        for (i = 0; i < s->net.nx; i++) {
            //@ ghost fact_square(i, s->net.nx - 1);
            //@ assert rows: i*i <= SIZE_MAX / 4;
            //@ ghost if (j > 0) fact_square(j - 1, s->net.ny - 1);
            /*@ loop invariant place:   j <= s->net.ny && (i >= 1 || k >= 1 || 1 <= j);
                loop invariant columns: j > 0 ==> (j - 1)*(j - 1) <= SIZE_MAX / 4;
                loop assigns j;
                loop variant j;
            */
            while (j > 0 && i * i + (j - 1) * (j - 1) + k > greatest) {
                //@ ghost if (j > 1) fact_square(j - 2, s->net.ny - 1);
                j--;
            }
            if (j == 0)
                break;
            s->reach[k][i] = j;
        }
        s->rows[k] = i;
    }
}

/* alpha(t), sigma(t), and from them the table of factors and the reaches. */
/*@ requires training: training_net(s) && training_tables(s) && training_apart(s) && training_listed(s);
    requires reaches:  s->within == 0 || training_reaches(s);
    assigns  s->factor[0 .. s->limit - 1], s->within, s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1], s->rows[0 .. 1];
    ensures  within:   1 <= s->within <= s->distinct;
    ensures  reaches:  training_reaches(s);
*/
static void decay(training *s, size_t t)
{
    const double shrink = s->tau > 0 ? et_real_exp(-((double)t / s->tau)) : 1;
    const double alpha = s->alpha0 * shrink, sigma = s->sigma0 * shrink, s2 = sigma * sigma;
    size_t within = 0;

    /*@ loop invariant place: within < s->distinct;
        loop assigns within, s->factor[0 .. s->limit - 1];
        loop variant s->distinct - within;
    */
    do { /* 0 is always within */
        s->factor[s->dist2[within]] = alpha * et_real_exp(-((double)s->dist2[within] / (2 * s2)));
        within++;
    } while (within < s->distinct && (double)s->dist2[within] < s2);
    //@ assert kept: s->within == 0 || training_reaches(s);
    if (within != s->within)
        set_reach(s, s->dist2[within - 1]);
    //@ assert reached: training_reaches(s);
    s->within = within;
    //@ assert bottom: training_level(s, 0, s->rows[0]);
    //@ assert next: training_level(s, 1, s->rows[1]);
}

/* Move towards the input the classes of row i on one level with j in from .. to; class j stands at array index at + j. */
/*@ requires training: training_net(s) && training_tables(s) && training_reaches(s) && training_space(s);
    requires winner:   et_net_inside(s->net.nx, s->net.ny, s->winner.i, s->winner.j);
    requires level:    et_absdiff(level, s->winner.k) <= 1;
    requires row:      i < s->net.nx && from < s->net.ny && to < s->net.ny;
    requires range:    from <= to ==> at + to < s->w.classes;
    assigns  s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1];
*/
static void pull(training *s, size_t i, size_t level, size_t from, size_t to, size_t at)
{
    const size_t row = s->winner.i, column = s->winner.j, away = i < row ? row - i : i - row;
    //@ ghost fact_square(away, s->net.nx - 1);
    const size_t k = level < s->winner.k ? s->winner.k - level : level - s->winner.k, reach = away < s->rows[k] ? s->reach[k][away] : 0;
    const double px = s->input.x, py = s->input.y, pz = s->input.z, *factor = s->factor + away * away + k;
    double *restrict x = s->w.x + at, *restrict y = s->w.y + at, *restrict z = s->w.z + at;

    //@ assert level: k == 0 || k == 1;
    if (reach == 0)
        return;
    //@ assert bottom: k == 0 ==> away < s->rows[0] && reach == s->reach[0][away];
    //@ assert next: k == 1 ==> away < s->rows[1] && reach == s->reach[1][away];
    //@ assert bottom: k == 0 ==> reach <= s->net.ny && away*away + (reach - 1)*(reach - 1) < s->limit;
    //@ assert next: k == 1 ==> reach <= s->net.ny && away*away + (reach - 1)*(reach - 1) + 1 < s->limit;
    //@ assert corner: reach <= s->net.ny && away*away + (reach - 1)*(reach - 1) + k < s->limit;
    //@ ghost fact_product(2, s->net.nx, s->net.ny);
    if (column + 1 > from + reach)
        from = column + 1 - reach;
    if (column + reach - 1 < to)
        to = column + reach - 1;
    /*@ loop invariant place:  from <= j && (from <= to ==> j <= to + 1);
        loop assigns j, s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1];
        loop variant to + 1 - j;
    */
    for (size_t j = from; j <= to; j++) {
        const size_t across = j < column ? column - j : j - column;
        //@ assert near: across <= reach - 1;
        //@ ghost fact_square(across, reach - 1);
        const double f = factor[across * across];

        x[j] += f * (px - x[j]);
        y[j] += f * (py - y[j]);
        z[j] += f * (pz - z[j]);
    }
}

/* Every class within the radius, but none of the opposite view's interior (K = 2). */
/*@ requires training: training_net(s) && training_tables(s) && training_reaches(s) && training_space(s);
    requires winner:   et_index_ok(s->net.nx, s->net.ny, s->winner.i, s->winner.j, s->winner.k);
    assigns  s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1];
*/
static void pull_all(training *s)
{
    const size_t nx = s->net.nx, ny = s->net.ny, row = s->winner.i, column = s->winner.j, reach = s->rows[0]; /* rows[1] <= rows[0] */
    const size_t first = row + 1 > reach ? row + 1 - reach : 0, last = row + reach - 1 < nx - 1 ? row + reach - 1 : nx - 1;
    const size_t widest = s->reach[0][0];

    //@ ghost fact_product(2, nx, ny);
    //@ ghost fact_product(2, ny, nx);
    //@ ghost fact_product(0, nx - 2, ny - 2);
    //@ ghost if (ny > 2) fact_product(1, ny - 2, nx - 2);
    /*@ loop invariant place:  first <= i <= last + 1;
        loop assigns i, s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1];
        loop variant last + 1 - i;
    */
    for (size_t i = first; i <= last; i++) {
        //@ ghost fact_product(i + 1, nx, ny);
        //@ ghost if (i > 0) fact_product(0, i - 1, ny - 2);
        //@ ghost if (0 < i && i < nx - 1) fact_product(i, nx - 2, ny - 2);
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

/*@ requires space:   \valid_read(w) && \valid(weights + (0 .. w->classes - 1)) && \valid_read(w->x + (0 .. w->classes - 1))
                      && \valid_read(w->y + (0 .. w->classes - 1)) && \valid_read(w->z + (0 .. w->classes - 1));
    requires apart:   \separated(weights + (0 .. w->classes - 1), w, w->x + (0 .. w->classes - 1))
                      && \separated(weights + (0 .. w->classes - 1), w->y + (0 .. w->classes - 1), w->z + (0 .. w->classes - 1));
    assigns  weights[0 .. w->classes - 1];
*/
static void unload(et_vec3 *weights, const winner_space *w)
{
    /*@ loop invariant place: c <= w->classes;
        loop assigns c, weights[0 .. w->classes - 1];
        loop variant w->classes - c;
    */
    for (size_t c = 0; c < w->classes; c++) {
        weights[c].x = w->x[c];
        weights[c].y = w->y[c];
        weights[c].z = w->z[c];
    }
}

/*@ requires options: \valid_read(o);
    assigns  \nothing;
    ensures  truth:   \result == 0 || \result == 1;
    ensures  valid:   \result == 1 <==> et_som_options_ok(*o);
*/
static int valid_options(const et_som_options *o)
{
    return o->iterations > 0 && o->alpha0 > 0 && o->alpha0 <= 1 && o->sigma0 >= 0 && isfinite(o->sigma0);
}

/* One step with the input that was drawn. */
/*@ requires training: training_net(s) && training_tables(s) && training_listed(s)
                           && winner_arrays(&s->w) && winner_indexed(&s->w, s->net.nx, s->net.ny);
    requires score:    tally_arrays(&s->score, t) && s->score.count + 1 == t;
    requires apart:    training_blocks(s, t);
    requires reaches:  s->within == 0 || training_reaches(s);
    assigns  s->winner, s->within, s->rows[0 .. 1], s->w.least[0 .. 15], s->score.least, s->score.greatest, s->score.apart, s->score.count,
             s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1], s->w.d[0 .. s->w.padded - 1],
             s->factor[0 .. s->limit - 1], s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1],
             s->score.error[0 .. TALLY_BLOCK - 1], s->score.block[0 .. t / TALLY_BLOCK];
    ensures  counted:  s->score.count == t && s->score.apart <= s->score.count;
    ensures  reaches:  training_reaches(s);
    ensures  winner:   et_index_ok(s->net.nx, s->net.ny, s->winner.i, s->winner.j, s->winner.k);
*/
static void train_step(training *s, size_t t)
{
    const winner_pair pair = winner_find(&s->w, s->input);

    s->winner = s->w.index[pair.first];
    tally_add(&s->score, &s->w, pair);
    decay(s, t);
    pull_all(s);
}

/* All steps, or those before the task stops them. */
/*@ requires training: training_net(s) && training_tables(s) && training_listed(s)
                           && winner_arrays(&s->w) && winner_indexed(&s->w, s->net.nx, s->net.ny);
    requires score:    tally_arrays(&s->score, iterations) && s->score.count == 0 && 1 <= iterations < SIZE_MAX && s->within == 0;
    requires apart:    training_blocks(s, iterations);
    requires given:    \valid_read(cloud + (0 .. n - 1)) && 1 <= n && \valid(rng) && (task == \null || \valid_read(task));
    requires rng:      \separated(rng, s, s->w.index + (0 .. s->w.classes - 1), s->dist2 + (0 .. s->distinct - 1));
    assigns  *rng, s->input, s->winner, s->within, s->rows[0 .. 1], s->w.least[0 .. 15], s->score.least, s->score.greatest, s->score.apart,
             s->score.count, s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1],
             s->w.d[0 .. s->w.padded - 1], s->factor[0 .. s->limit - 1], s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1],
             s->score.error[0 .. TALLY_BLOCK - 1], s->score.block[0 .. iterations / TALLY_BLOCK];
    ensures  some:     1 <= s->score.count <= iterations && s->score.apart <= s->score.count;
    ensures  all:      \result == ET_OK ==> s->score.count == iterations;
    ensures  nobody:   task == \null ==> \result == ET_OK;
*/
static et_status train(training *s, const et_vec3 *cloud, size_t n, size_t iterations, et_rng *rng, const et_task *task)
{
    et_status status = ET_OK;

    /*@ loop invariant place:   1 <= t <= iterations + 1 && (t == 1 || task == \null ==> status == ET_OK);
        loop invariant score:   tally_arrays(&s->score, iterations) && s->score.count == t - 1;
        loop invariant reaches: s->within == 0 || training_reaches(s);
        loop assigns t, status, *rng, s->input, s->winner, s->within, s->rows[0 .. 1], s->w.least[0 .. 15], s->score.least, s->score.greatest,
                     s->score.apart, s->score.count, s->w.x[0 .. s->w.padded - 1], s->w.y[0 .. s->w.padded - 1], s->w.z[0 .. s->w.padded - 1],
                     s->w.d[0 .. s->w.padded - 1], s->factor[0 .. s->limit - 1], s->reach[0][0 .. s->net.nx - 1], s->reach[1][0 .. s->net.nx - 1],
                     s->score.error[0 .. TALLY_BLOCK - 1], s->score.block[0 .. iterations / TALLY_BLOCK];
        loop variant iterations + 1 - t;
    */
    for (size_t t = 1; t <= iterations && status == ET_OK; t++) {
        s->input = cloud[et_rng_index(rng, n)];
        train_step(s, t);
        if (t % STEPS_PER_REPORT == 0 && t < iterations)
            status = et_task_step(task, t, iterations);
    }
    return status;
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
    /*@ assert fresh: \separated(weights + (0 .. nov - 1), s.w.x + (0 .. s.w.padded - 1), s.w.y + (0 .. s.w.padded - 1),
                                    s.w.z + (0 .. s.w.padded - 1), s.w.d + (0 .. s.w.padded - 1), s.w.index + (0 .. s.w.classes - 1),
                                    s.factor + (0 .. s.limit - 1), s.dist2 + (0 .. s.distinct - 1), s.reach[0] + (0 .. s.net.nx - 1),
                                    s.reach[1] + (0 .. s.net.nx - 1), s.score.error + (0 .. TALLY_BLOCK - 1),
                                    s.score.block + (0 .. options->iterations / TALLY_BLOCK)); */
    //@ assert memory: options->iterations < SIZE_MAX;
    winner_load(&s.w, weights);
    status = train(&s, cloud, n, options->iterations, rng, task);
    unload(weights, &s.w);
    *quality = tally_quality(&s.score);
    training_free(&s);
    return status;
}
