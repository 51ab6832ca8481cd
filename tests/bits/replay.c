/* replay: whole runs of every seeded or deterministic algorithm, and one line a run: its name and a hash of the bits of all its results.
 *
 * replay [-v] FOLDER [NAME...]    FOLDER takes the files that are written and read back; -v prints each result, too
 *
 * Two builds, or two processors, that print the same have the same bits everywhere.  (Golden rows are short and are checked against values from
 * elsewhere; these are long and are checked against each other.)  LAPACK's own results are not here: they belong to the BLAS.
 */
#include "etalon/base/frame.h"
#include "etalon/base/real.h"
#include "etalon/base/rng.h"
#include "etalon/base/size.h"
#include "etalon/fit/enclosure.h"
#include "etalon/fit/fit.h"
#include "etalon/fit/seam.h"
#include "etalon/io/cloud.h"
#include "etalon/io/iges.h"
#include "etalon/io/json.h"
#include "etalon/io/primitive.h"
#include "etalon/io/tessellation.h"
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/pso.h"
#include "etalon/som/quality.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH = 4096, NET_X = 12, NET_Y = 9, DATA = 2 * (NET_X * NET_Y - NET_X - NET_Y + 2), POINTS = 1000 };

static uint64_t hash;
static int verbose;
static const char *folder, *running;
static et_vec3 data[DATA];               /* the net of the run som_sphere: what the others fit */
static et_net_file net;

/* ---- hashing: FNV-1a over values, so that the order of bytes in memory does not matter --------------------------------- */

static void put_word(uint64_t word)
{
    for (int k = 0; k < 8; k++)
        hash = (hash ^ (word >> 8 * k & 0xff)) * UINT64_C(0x100000001b3);
}

static void put_count(size_t n)
{
    if (verbose)
        printf("%s %zu\n", running, n);
    put_word(n);
}

static void put(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    if (verbose)
        printf("%s %a\n", running, x);
    put_word(bits);
}

static void put_all(const double *x, size_t n)
{
    for (size_t i = 0; i < n; i++)
        put(x[i]);
}

static void put_points(const et_vec3 *p, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        put(p[i].x);
        put(p[i].y);
        put(p[i].z);
    }
}

/* A run that cannot go on is no result at all. */
static void must(int ok, const char *what)
{
    if (!ok) {
        fprintf(stderr, "replay %s: %s failed\n", running, what);
        exit(1);
    }
}

static void put_file(const char *path)
{
    FILE *f = fopen(path, "rb");
    int c;

    must(f != NULL, path);
    while ((c = getc(f)) != EOF)
        hash = (hash ^ (uint64_t)c) * UINT64_C(0x100000001b3);
    fclose(f);
}

static et_rng *seeded(uint64_t seed)
{
    et_rng *rng = NULL;

    must(et_rng_new(&rng, seed) == ET_OK, "et_rng_new");
    return rng;
}

static void *array(size_t count, size_t size)
{
    void *p = et_size_array(count, size);

    must(p != NULL, "et_size_array");
    return p;
}

/* ---- base ------------------------------------------------------------------------------------------------------------ */

static void run_rng(void)
{
    static const uint64_t seeds[] = {0, 1, 4357, UINT64_C(1) << 40, UINT64_MAX};

    for (size_t s = 0; s < sizeof seeds / sizeof *seeds; s++) {
        et_rng *rng = seeded(et_rng_stream(seeds[s], s));
        for (size_t k = 0; k < 20000; k++)
            put(et_rng_uniform(rng));
        for (size_t k = 0; k < 5000; k++)
            put(et_rng_normal(rng));
        for (size_t k = 1; k < 5000; k++)
            put_count(et_rng_index(rng, k * k * 100));
        et_rng_seek(rng, 1000003);
        put(et_rng_uniform(rng));
        et_rng_free(rng);
    }
}

/* A double of any size from 2^-e to 2^e. */
static double wide(et_rng *rng, size_t e)
{
    double x = 1.0 + et_rng_uniform(rng);

    for (size_t k = et_rng_index(rng, e); k > 0; k--)
        x = et_rng_uniform(rng) < 0.5 ? 2.0 * x : 0.5 * x;
    return x;
}

static void run_real(void)
{
    et_rng *rng = seeded(11);

    for (size_t k = 0; k < 5000; k++) {
        const double x = wide(rng, 100), y = 40.0 * et_rng_uniform(rng) - 20.0;
        put(et_real_exp(y));
        put(et_real_log(x));
        put(et_real_pow(x, y));
        put(et_real_pow(x, 0.8));
        put(et_real_sin(x));
        put(et_real_cos(y));
    }
    et_rng_free(rng);
}

static void run_sum(void)
{
    static double x[3000];
    et_rng *rng = seeded(12);

    for (size_t k = 0; k < sizeof x / sizeof *x; k++)
        x[k] = wide(rng, 60) * (et_rng_uniform(rng) - 0.5);
    for (size_t n = 0; n <= sizeof x / sizeof *x; n += 7)
        put(et_real_sum(x, n));
    et_rng_free(rng);
}

/* ---- clouds and nets ---------------------------------------------------------------------------------------------------- */

/* The unit cube's cloud of a primitive with noise; *n points. */
static et_vec3 *cloud(size_t *n, et_primitive_kind kind, size_t side, uint64_t seed)
{
    et_rng *rng = seeded(seed);
    et_frame frame;
    et_vec3 *p;

    must(et_primitive_count(n, kind, side, side + 3) == ET_OK, "et_primitive_count");
    p = array(*n, sizeof *p);
    must(et_primitive_make(p, *n, kind, side, side + 3) == ET_OK, "et_primitive_make");
    must(et_primitive_disturb(p, *n, 0.01, 0.05, rng) == ET_OK, "et_primitive_disturb");
    must(et_frame_of(&frame, p, *n, ET_FRAME_BOX) == ET_OK, "et_frame_of");
    et_frame_to_unit(p, *n, &frame);
    et_rng_free(rng);
    return p;
}

static void run_primitive(void)
{
    for (int kind = 0; kind < 4; kind++) {
        size_t n;
        et_vec3 *p = cloud(&n, (et_primitive_kind)kind, 30, (uint64_t)kind);
        put_points(p, n);
        free(p);
    }
}

static void put_quality(et_som_quality q)
{
    put(q.qe);
    put(q.te);
    put(q.min_error);
    put(q.max_error);
    put_count(q.steps);
}

static et_net_file trained(et_vec3 *weights, et_doublenet sides, et_primitive_kind kind, size_t side, size_t steps, uint64_t seed)
{
    const size_t nov = et_doublenet_nov(sides);
    et_net_file t;
    et_rng *rng = seeded(seed);
    size_t n;
    et_vec3 *p = cloud(&n, kind, side, seed);

    memset(&t, 0, sizeof t);
    t.net = sides;
    t.weights = weights;
    t.frame.scale = (et_vec3){1.0, 1.0, 1.0};
    t.options = et_som_defaults();
    t.options.iterations = steps;
    t.seed = seed;
    et_som_start(weights, nov, rng);
    must(et_som_train(weights, nov, &t.training, sides, p, n, &t.options, rng, NULL) == ET_OK, "et_som_train");
    must(et_quality_of(&t.final, weights, nov, sides, p, n) == ET_OK, "et_quality_of");
    put_points(weights, nov);
    put_quality(t.training);
    put_quality(t.final);
    et_rng_free(rng);
    free(p);
    return t;
}

static void run_som_cube(void)
{
    const et_doublenet sides = {20, 20};
    et_vec3 *weights = array(et_doublenet_nov(sides), sizeof *weights);

    trained(weights, sides, ET_PRIMITIVE_CUBE, 20, 10000, 6);
    free(weights);
}

static void run_som_sphere(void)
{
    const et_doublenet sides = {NET_X, NET_Y};

    net = trained(data, sides, ET_PRIMITIVE_SPHERE, 25, 30000, 5);
}

/* ---- fits --------------------------------------------------------------------------------------------------------------- */

static const et_doublenet sides_of_data = {NET_X, NET_Y};

static et_fit_options usual(void)
{
    et_fit_options o = et_fit_defaults();

    o.control = (et_doublenet){6, 5};
    return o;
}

static et_fit fitted(const et_fit_options *o)
{
    et_fit fit;

    must(et_fit_make(&fit, data, DATA, sides_of_data, o, NULL) == ET_OK, "et_fit_make");
    return fit;
}

static void put_shell(const et_shell *shell)
{
    for (size_t w = 0; w < 2; w++) {
        const et_surface *s = &shell->view[w];
        put_all(s->u, s->nu + s->p + 1);
        put_all(s->v, s->nv + s->q + 1);
        put_points(s->points, s->nu * s->nv);
    }
}

static void put_fit(const et_fit *fit)
{
    et_fit_error error;
    et_seam seam;

    must(et_fit_measure(&error, NULL, DATA, fit, data) == ET_OK, "et_fit_measure");
    must(et_seam_gap(&seam, &fit->shell, 16) == ET_OK, "et_seam_gap");
    put_shell(&fit->shell);
    for (size_t w = 0; w < 2; w++) {
        put_all(fit->s[w], NET_X);
        put_all(fit->r[w], NET_Y);
    }
    put(error.nov);
    put(error.non);
    put(error.greatest);
    put(error.corner);
    put(seam.distance);
}

static void fit_all(et_fit_approach approach)
{
    for (int method = 0; method < 4; method++)
        for (int knots = 0; knots < 3; knots++) {
            et_fit_options o = usual();
            et_fit fit;
            o.approach = approach;
            o.method = (et_param_method)method;
            o.knots = (et_knotrule_kind)knots;
            if (et_fit_make(&fit, data, DATA, sides_of_data, &o, NULL) != ET_OK) {
                put_count(1);            /* rank deficient with these knots: everywhere */
                continue;
            }
            put_fit(&fit);
            et_fit_free(&fit);
        }
}

static void run_fit_conventional(void)
{
    fit_all(ET_FIT_CONVENTIONAL);
}

static void run_fit_improved(void)
{
    fit_all(ET_FIT_IMPROVED);
}

static void run_fit_joint(void)
{
    fit_all(ET_FIT_JOINT);
}

/* A solution refined until it is correctly rounded does not remember the algebra that it came from. */
static void refined(et_linalg_method algebra)
{
    for (int approach = 0; approach < 3; approach++) {
        et_fit_options o = usual();
        et_enclosure enclosure;
        et_fit fit;
        o.approach = (et_fit_approach)approach;
        o.algebra = algebra;
        fit = fitted(&o);
        must(et_enclosure_refine(&fit, &enclosure, data, DATA, &o, NULL) == ET_OK, "et_enclosure_refine");
        must(enclosure.undecided == 0, "rounding");
        put_fit(&fit);
        et_enclosure_free(&enclosure);
        et_fit_free(&fit);
    }
}

static void run_refined_qr(void)
{
    refined(ET_LINALG_QR);
}

static void run_refined_cholesky(void)
{
    refined(ET_LINALG_CHOLESKY);
}

static void run_refined_svd(void)
{
    refined(ET_LINALG_SVD);
}

static void run_surface(void)
{
    const et_fit_options o = usual();
    et_fit fit = fitted(&o);
    et_surface *s = &fit.shell.view[ET_TOP];
    const size_t nwork = et_surface_work(s);
    double *work = array(nwork, sizeof *work);
    et_rng *rng = seeded(13);

    for (int rational = 0; rational < 2; rational++) {
        if (rational) {
            s->weights = array(s->nu * s->nv, sizeof *s->weights);
            for (size_t k = 0; k < s->nu * s->nv; k++)
                s->weights[k] = wide(rng, 4);
        }
        for (size_t k = 0; k < POINTS; k++) {
            const double u = et_rng_uniform(rng), v = et_rng_uniform(rng);
            const et_vec3 point = et_surface_point(s, u, v, work, nwork);
            et_vec3 D[6];
            et_surface_ders(D, s, u, v, work, nwork);
            put_points(&point, 1);
            put_points(D, 6);
        }
    }
    et_rng_free(rng);
    free(work);
    et_fit_free(&fit);
}

/* ---- searches ----------------------------------------------------------------------------------------------------------- */

static void search(et_search_step step, int velocities, uint64_t seed)
{
    enum { GENERATIONS = 300 };
    static double history[GENERATIONS];
    const et_fit_options o = usual();
    et_search_options how = et_search_defaults();
    et_fit fit = fitted(&o);
    et_objective *objective = NULL;
    et_rng *rng = seeded(seed);
    double start[3 * DATA];
    et_search s;
    size_t made, n;

    must(et_objective_new(&objective, &fit, data, DATA) == ET_OK, "et_objective_new");
    n = et_objective_size(objective);
    et_shell_gather((et_vec3 *)(void *)start, n / 3, &fit.shell);
    how.group = 3;
    how.spread = how.box = how.vmax = 1e-3;
    must(et_search_start(&s, start, n, &how, velocities, et_objective_eval, objective, rng) == ET_OK, "et_search_start");
    must(et_search_run(&s, &made, history, GENERATIONS, step, rng, NULL) == ET_OK, "et_search_run");
    put_all(history, GENERATIONS);
    put_all(s.best, n);
    put_all(s.x, n * how.population);
    put_all(s.value, how.population);
    put_word(et_rng_tell(rng));
    put_word(s.evaluations);
    et_search_free(&s);
    et_objective_free(objective);
    et_rng_free(rng);
    et_fit_free(&fit);
}

static void run_ga(void)
{
    search(et_ga_step, 0, 21);
}

static void run_de(void)
{
    search(et_de_step, 0, 22);
}

static void run_pso(void)
{
    search(et_pso_step, 1, 23);
}

/* ---- files -------------------------------------------------------------------------------------------------------------- */

static const char *file(const char *name)
{
    static char path[PATH];
    const int n = snprintf(path, sizeof path, "%s/%s", folder, name);

    must(n > 0 && n < PATH, "the folder's name");
    return path;
}

static void run_files_json(void)
{
    const et_fit_options o = usual();
    et_surface_file surface, back;
    et_net_file read;

    must(et_json_write_net(file("net.json"), &net, NULL) == ET_OK, "et_json_write_net");
    must(et_json_read_net(&read, file("net.json"), NULL) == ET_OK, "et_json_read_net");
    put_file(file("net.json"));
    put_points(read.weights, DATA);
    et_json_free_net(&read);

    memset(&surface, 0, sizeof surface);
    surface.options = o;
    surface.fit = fitted(&o);
    surface.frame = (et_frame){{0.1, -7.0, 1e300}, {3.0, 1e-300, 1e10}};
    must(et_json_write_surface(file("surface.json"), &surface, NULL) == ET_OK, "et_json_write_surface");
    must(et_json_read_surface(&back, file("surface.json"), NULL) == ET_OK, "et_json_read_surface");
    put_file(file("surface.json"));
    put_fit(&back.fit);
    et_json_free_surface(&back);
    et_fit_free(&surface.fit);
}

static void run_files_cad(void)
{
    const et_frame frame = {{0.1, -7.0, 3e10}, {3.0, 0.7, 1e10}};
    const et_fit_options o = usual();
    et_fit fit = fitted(&o);
    et_tessellation mesh;

    must(et_iges_write(file("surface.igs"), &fit.shell, &frame, NULL) == ET_OK, "et_iges_write");
    put_file(file("surface.igs"));
    must(et_tessellation_of(&mesh, &fit.shell, &frame, 20, 17) == ET_OK, "et_tessellation_of");
    put_points(mesh.vertices, mesh.nvertices);
    put(et_tessellation_volume(&mesh));
    must(et_tessellation_write_obj(file("mesh.obj"), &mesh, NULL) == ET_OK, "et_tessellation_write_obj");
    put_file(file("mesh.obj"));
    must(et_tessellation_write_stl(file("mesh.stl"), &mesh, NULL) == ET_OK, "et_tessellation_write_stl");
    put_file(file("mesh.stl"));
    et_tessellation_free(&mesh);
    et_fit_free(&fit);
}

static void run_files_cloud(void)
{
    static const char *const names[] = {"cloud.xyz", "cloud.ascii.ply", "cloud.ply", "cloud.big.ply"};
    size_t n;
    et_vec3 *p = cloud(&n, ET_PRIMITIVE_SPINDLE, 20, 31);

    for (int k = 0; k < 4; k++) {
        et_cloud back;
        must(et_cloud_write(file(names[k]), p, n, (et_cloud_format)k, NULL) == ET_OK, "et_cloud_write");
        put_file(file(names[k]));
        must(et_cloud_read(&back, file(names[k]), NULL) == ET_OK, "et_cloud_read");
        put_points(back.points, back.count);
        et_cloud_free(&back);
    }
    free(p);
}

/* ------------------------------------------------------------------------------------------------------------------------- */

typedef struct { const char *name; void (*run)(void); } entry;

static int wanted(const char *name, char **names)
{
    if (!*names)
        return 1;
    for (; *names; names++)
        if (strcmp(name, *names) == 0)
            return 1;
    return 0;
}

int main(int argc, char **argv)
{
    static const entry runs[] = {
        {"som_sphere", run_som_sphere},  /* first: the others fit its net */
        {"rng", run_rng}, {"real", run_real}, {"sum", run_sum}, {"primitive", run_primitive}, {"som_cube", run_som_cube},
        {"fit_conventional", run_fit_conventional}, {"fit_improved", run_fit_improved}, {"fit_joint", run_fit_joint}, {"surface", run_surface},
        {"ga", run_ga}, {"de", run_de}, {"pso", run_pso},
        {"files_json", run_files_json}, {"files_cad", run_files_cad}, {"files_cloud", run_files_cloud},
        {"refined_qr", run_refined_qr}, {"refined_cholesky", run_refined_cholesky}, {"refined_svd", run_refined_svd},
    };
    int at = 1;

    if (at < argc && strcmp(argv[at], "-v") == 0)
        verbose = at++;
    if (at >= argc) {
        fputs("replay [-v] FOLDER [NAME...]\n", stderr);
        return 2;
    }
    folder = argv[at++];
    for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
        const int tell = wanted(runs[k].name, argv + at), was = verbose;
        if (k > 0 && !tell)
            continue;
        hash = UINT64_C(0xcbf29ce484222325);
        running = runs[k].name;
        verbose = verbose && tell;
        runs[k].run();
        verbose = was;
        if (tell)
            printf("%s %016" PRIx64 "\n", runs[k].name, hash);
        fflush(stdout);
    }
    return 0;
}
