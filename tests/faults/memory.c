/* memory: each function that asks for memory is refused it at its first, second, ... request: then it has to say ET_ENOMEM, leave its outputs as they
 * were and keep nothing.  Linked with --wrap, so that only the library's own requests count, not those of the libraries under it.
 * In the same way every product of sizes overflows in turn, as in a narrower size_t, and every call of LAPACK fails: without memory, or for no
 * reason. */
#include "etalon/conform/answer.h"
#include "etalon/conform/campaign.h"
#include "etalon/conform/conform.h"
#include "etalon/conform/judge.h"
#include "etalon/conform/vectors.h"
#include "etalon/base/real.h"
#include "etalon/base/rng.h"
#include "etalon/base/size.h"
#include "etalon/exact/exact.h"
#include "etalon/fit/enclosure.h"
#include "etalon/io/cloud.h"
#include "etalon/io/iges.h"
#include "etalon/io/json.h"
#include "etalon/io/tessellation.h"
#include "etalon/refine/ceres.h"
#include "etalon/refine/de.h"
#include "etalon/refine/ga.h"
#include "etalon/refine/objective.h"
#include "etalon/refine/optimum.h"
#include "etalon/refine/pso.h"
#include "etalon/refine/search.h"
#include "etalon/som/som.h"
#include <errno.h>
#include <lapacke.h>
#include <locale.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- the wrapped calls -------------------------------------------------------------------------------------------------------- */

enum { SLOTS = 1 << 16 };
static void *held[SLOTS];                /* what the library holds; open addressing */
static size_t requests, refuse_at, live;
static enum { MEMORY, SIZES, LAPACK_MEMORY, LAPACK_FAULT, WAYS } way;
static const struct { const char *name; et_status status; } ways[] = {
    { "", ET_ENOMEM }, { "sizes", ET_ENOMEM }, { "lapack's memory", ET_ENOMEM }, { "lapack", ET_EINTERNAL } };

void *__real_malloc(size_t n);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t n);
int __real_posix_memalign(void **p, size_t align, size_t n);
void __real_free(void *p);
void *__wrap_malloc(size_t n);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t n);
int __wrap_posix_memalign(void **p, size_t align, size_t n);
void __wrap_free(void *p);

static size_t slot(const void *p)
{
    size_t k = ((size_t)p >> 4) % SLOTS;

    while (held[k] && held[k] != p)
        k = (k + 1) % SLOTS;
    return k;
}

static void *hold(void *p)
{
    if (p) {
        held[slot(p)] = p;
        live++;
    }
    return p;
}

/* Those behind a freed place of the table move up. */
static void let_go(void *p)
{
    size_t k = slot(p);

    if (!p || !held[k])
        return;
    live--;
    held[k] = NULL;
    for (k = (k + 1) % SLOTS; held[k]; k = (k + 1) % SLOTS) {
        void *q = held[k];
        held[k] = NULL;
        held[slot(q)] = q;
    }
}

static int refused(void)
{
    return way == MEMORY && ++requests == refuse_at;
}

void *__wrap_malloc(size_t n)
{
    return refused() ? NULL : hold(__real_malloc(n));
}

void *__wrap_calloc(size_t n, size_t size)
{
    return refused() ? NULL : hold(__real_calloc(n, size));
}

void *__wrap_realloc(void *p, size_t n)
{
    void *q = refused() ? NULL : __real_realloc(p, n);

    if (q) {
        let_go(p);
        hold(q);
    }
    return q;
}

int __wrap_posix_memalign(void **p, size_t align, size_t n)
{
    const int bad = refused() ? 12 : __real_posix_memalign(p, align, n);

    if (!bad)
        hold(*p);
    return bad;
}

void __wrap_free(void *p)
{
    let_go(p);
    __real_free(p);
}

/* C++'s operator new; being asked for more than there is it throws. */
void *__real__Znwm(size_t n);
void *__wrap__Znwm(size_t n);

void *__wrap__Znwm(size_t n)
{
    return __real__Znwm(refused() ? SIZE_MAX / 2 : n);
}

/* What the C library asks for on the library's behalf: copies of texts, locales, all that a program is started with. */
char *__real_strdup(const char *text);
char *__wrap_strdup(const char *text);
locale_t __real_newlocale(int mask, const char *name, locale_t base);
locale_t __wrap_newlocale(int mask, const char *name, locale_t base);
typedef posix_spawn_file_actions_t spawn_files;          /* the prototypes fit on a line each */
typedef posix_spawnattr_t spawn_attributes;
int __real_posix_spawn_file_actions_init(spawn_files *a);
int __wrap_posix_spawn_file_actions_init(spawn_files *a);
int __real_posix_spawn_file_actions_adddup2(spawn_files *a, int fd, int as);
int __wrap_posix_spawn_file_actions_adddup2(spawn_files *a, int fd, int as);
int __real_posix_spawn_file_actions_addclose(spawn_files *a, int fd);
int __wrap_posix_spawn_file_actions_addclose(spawn_files *a, int fd);
int __real_posix_spawnattr_init(spawn_attributes *a);
int __wrap_posix_spawnattr_init(spawn_attributes *a);
int __real_posix_spawnattr_setflags(spawn_attributes *a, short flags);
int __wrap_posix_spawnattr_setflags(spawn_attributes *a, short flags);
int __real_posix_spawnattr_setpgroup(spawn_attributes *a, pid_t group);
int __wrap_posix_spawnattr_setpgroup(spawn_attributes *a, pid_t group);
int __real_posix_spawnattr_setsigdefault(spawn_attributes *a, const sigset_t *set);
int __wrap_posix_spawnattr_setsigdefault(spawn_attributes *a, const sigset_t *set);
int __real_posix_spawnattr_setsigmask(spawn_attributes *a, const sigset_t *set);
int __wrap_posix_spawnattr_setsigmask(spawn_attributes *a, const sigset_t *set);

char *__wrap_strdup(const char *text)
{
    if (!refused())
        return hold(__real_strdup(text));
    errno = ENOMEM;
    return NULL;
}

locale_t __wrap_newlocale(int mask, const char *name, locale_t base)
{
    if (!refused())
        return __real_newlocale(mask, name, base);
    errno = ENOMEM;
    return (locale_t)0;
}

int __wrap_posix_spawn_file_actions_init(spawn_files *a)
{
    return refused() ? ENOMEM : __real_posix_spawn_file_actions_init(a);
}

int __wrap_posix_spawn_file_actions_adddup2(spawn_files *a, int fd, int as)
{
    return refused() ? ENOMEM : __real_posix_spawn_file_actions_adddup2(a, fd, as);
}

int __wrap_posix_spawn_file_actions_addclose(spawn_files *a, int fd)
{
    return refused() ? ENOMEM : __real_posix_spawn_file_actions_addclose(a, fd);
}

int __wrap_posix_spawnattr_init(spawn_attributes *a)
{
    return refused() ? ENOMEM : __real_posix_spawnattr_init(a);
}

int __wrap_posix_spawnattr_setflags(spawn_attributes *a, short flags)
{
    return refused() ? ENOMEM : __real_posix_spawnattr_setflags(a, flags);
}

int __wrap_posix_spawnattr_setpgroup(spawn_attributes *a, pid_t group)
{
    return refused() ? ENOMEM : __real_posix_spawnattr_setpgroup(a, group);
}

int __wrap_posix_spawnattr_setsigdefault(spawn_attributes *a, const sigset_t *set)
{
    return refused() ? ENOMEM : __real_posix_spawnattr_setsigdefault(a, set);
}

int __wrap_posix_spawnattr_setsigmask(spawn_attributes *a, const sigset_t *set)
{
    return refused() ? ENOMEM : __real_posix_spawnattr_setsigmask(a, set);
}

et_status __real_et_size_mul(size_t *product, size_t a, size_t b);
et_status __wrap_et_size_mul(size_t *product, size_t a, size_t b);
int __real_linalg_fits(size_t a, size_t b);
int __wrap_linalg_fits(size_t a, size_t b);

et_status __wrap_et_size_mul(size_t *product, size_t a, size_t b)
{
    return way == SIZES && ++requests == refuse_at ? ET_ENOMEM : __real_et_size_mul(product, a, b);
}

int __wrap_linalg_fits(size_t a, size_t b)
{
    return !(way == SIZES && ++requests == refuse_at) && __real_linalg_fits(a, b);
}

/* What a call of LAPACK says that is to fail, else 0. */
static lapack_int ill(void)
{
    if (way < LAPACK_MEMORY || ++requests != refuse_at)
        return 0;
    return way == LAPACK_MEMORY ? LAPACK_WORK_MEMORY_ERROR : -4;
}

typedef lapack_int whole;                     /* the prototypes fit on a line each */
whole __real_LAPACKE_dgeqp3(int o, whole m, whole n, double *a, whole lda, whole *pivot, double *tau);
whole __wrap_LAPACKE_dgeqp3(int o, whole m, whole n, double *a, whole lda, whole *pivot, double *tau);
whole __real_LAPACKE_dpotrf(int o, char uplo, whole n, double *a, whole lda);
whole __wrap_LAPACKE_dpotrf(int o, char uplo, whole n, double *a, whole lda);
whole __real_LAPACKE_dpocon(int o, char uplo, whole n, const double *a, whole lda, double norm, double *rcond);
whole __wrap_LAPACKE_dpocon(int o, char uplo, whole n, const double *a, whole lda, double norm, double *rcond);
whole __real_LAPACKE_dpotrs(int o, char uplo, whole n, whole k, const double *a, whole lda, double *b, whole ldb);
whole __wrap_LAPACKE_dpotrs(int o, char uplo, whole n, whole k, const double *a, whole lda, double *b, whole ldb);
whole __real_LAPACKE_dgelsd_work(int o, whole m, whole n, whole k, double *a, whole lda, double *b, whole ldb, double *s, double rcond, whole *rank,
                                double *w, whole lw, whole *iw);
whole __wrap_LAPACKE_dgelsd_work(int o, whole m, whole n, whole k, double *a, whole lda, double *b, whole ldb, double *s, double rcond, whole *rank,
                                double *w, whole lw, whole *iw);
whole __real_LAPACKE_dpbtrf(int o, char uplo, whole n, whole kd, double *ab, whole ldab);
whole __wrap_LAPACKE_dpbtrf(int o, char uplo, whole n, whole kd, double *ab, whole ldab);
whole __real_LAPACKE_dpbcon(int o, char uplo, whole n, whole kd, const double *ab, whole ldab, double norm, double *rcond);
whole __wrap_LAPACKE_dpbcon(int o, char uplo, whole n, whole kd, const double *ab, whole ldab, double norm, double *rcond);
whole __real_LAPACKE_dtbcon(int o, char norm, char uplo, char diag, whole n, whole kd, const double *ab, whole ldab, double *rcond);
whole __wrap_LAPACKE_dtbcon(int o, char norm, char uplo, char diag, whole n, whole kd, const double *ab, whole ldab, double *rcond);

whole __wrap_LAPACKE_dgeqp3(int o, whole m, whole n, double *a, whole lda, whole *pivot, double *tau)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dgeqp3(o, m, n, a, lda, pivot, tau);
}

whole __wrap_LAPACKE_dpotrf(int o, char uplo, whole n, double *a, whole lda)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dpotrf(o, uplo, n, a, lda);
}

whole __wrap_LAPACKE_dpocon(int o, char uplo, whole n, const double *a, whole lda, double norm, double *rcond)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dpocon(o, uplo, n, a, lda, norm, rcond);
}

whole __wrap_LAPACKE_dpotrs(int o, char uplo, whole n, whole k, const double *a, whole lda, double *b, whole ldb)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dpotrs(o, uplo, n, k, a, lda, b, ldb);
}

whole __wrap_LAPACKE_dgelsd_work(int o, whole m, whole n, whole k, double *a, whole lda, double *b, whole ldb, double *s, double rcond, whole *rank,
                                double *w, whole lw, whole *iw)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dgelsd_work(o, m, n, k, a, lda, b, ldb, s, rcond, rank, w, lw, iw);
}

whole __wrap_LAPACKE_dpbtrf(int o, char uplo, whole n, whole kd, double *ab, whole ldab)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dpbtrf(o, uplo, n, kd, ab, ldab);
}

whole __wrap_LAPACKE_dpbcon(int o, char uplo, whole n, whole kd, const double *ab, whole ldab, double norm, double *rcond)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dpbcon(o, uplo, n, kd, ab, ldab, norm, rcond);
}

whole __wrap_LAPACKE_dtbcon(int o, char norm, char uplo, char diag, whole n, whole kd, const double *ab, whole ldab, double *rcond)
{
    const whole info = ill();
    return info ? info : __real_LAPACKE_dtbcon(o, norm, uplo, diag, n, kd, ab, ldab, rcond);
}

/* ---- what the functions are given -------------------------------------------------------------------------------------------- */

enum { SIDE = 6, NOV = 2 * (SIDE * SIDE - 2 * SIDE + 2), CLOUD = 300, ROOM = 1 << 16 };
static const et_doublenet net = { SIDE, SIDE };
static et_vec3 data[NOV], cloud[CLOUD], points[4096];
static double reals[4096];
static et_fit_options options;
static const et_frame frame = { { 0, 0, 0 }, { 1, 1, 1 } };
static et_fit fit, worked;               /* worked: what a function changes in place, a copy of fit */
static et_curve arc;
static et_surface sheet;
static et_search search;
static et_rng *rng;
static et_request request;
static et_reply reply;
static et_net_file net_file;
static char net_path[256], surface_path[256], cloud_path[256], out_path[256];
static const char *folder_path;
static const char vectors_path[] = "golden/conformance/net_class.json";

static int put(const char *name, const char *text)
{
    char path[300];
    FILE *file;

    snprintf(path, sizeof path, "%s/%s", folder_path, name);
    file = fopen(path, "w");
    return file && fputs(text, file) >= 0 && fclose(file) == 0;
}

static et_vec3 somewhere(void)
{
    et_vec3 p;

    p.x = et_rng_uniform(rng);
    p.y = et_rng_uniform(rng);
    p.z = et_rng_uniform(rng);
    return p;
}

/* Clamped, with the inner knots 1/4, 1/2, 1/2, 3/4: nu - 2p - 2 <= 4 of them. */
static void some_knots(double *u, size_t nu, size_t p)
{
    static const double inner[] = { 0.25, 0.5, 0.5, 0.75 };

    for (size_t k = 0; k < nu; k++)
        u[k] = k <= p ? 0 : k + p + 1 >= nu ? 1 : inner[k - p - 1];
}

static int make_splines(void)
{
    if (et_curve_new(&arc, 3, 8, 1) != ET_OK || et_surface_new(&sheet, 2, 2, 6, 7, 1) != ET_OK)
        return 0;
    some_knots(arc.u, 12, 3);
    some_knots(sheet.u, 9, 2);
    some_knots(sheet.v, 10, 2);
    for (size_t k = 0; k < 8; k++)
        arc.points[k] = somewhere();
    for (size_t k = 0; k < 42; k++)
        sheet.points[k] = somewhere();
    return et_curve_valid(&arc) && et_surface_valid(&sheet);
}

static et_status value(double *v, const double *x, size_t n, void *context)
{
    (void)context;
    *v = et_real_sum(x, n);
    return ET_OK;
}

static int make_all(const char *folder)
{
    et_surface_file s;
    et_hello all = et_answer_hello(1);

    folder_path = folder;
    options = et_fit_defaults();
    options.control.nx = options.control.ny = 4;
    options.p = options.q = 2;
    options.approach = ET_FIT_JOINT;
    snprintf(net_path, sizeof net_path, "%s/net.json", folder);
    snprintf(surface_path, sizeof surface_path, "%s/surface.json", folder);
    snprintf(cloud_path, sizeof cloud_path, "%s/cloud.ply", folder);
    snprintf(out_path, sizeof out_path, "%s/out", folder);
    if (et_rng_new(&rng, 1) != ET_OK || !make_splines())
        return 0;
    for (size_t k = 0; k < NOV; k++)
        data[k] = somewhere();
    for (size_t k = 0; k < CLOUD; k++)
        cloud[k] = somewhere();
    if (et_fit_make(&fit, data, NOV, net, &options, NULL) != ET_OK
        || et_campaign_draw(&request, ET_OP_FIT_GRID, ET_CATEGORY_PLAIN, 1, 1, &all) != ET_OK || et_answer_exact(&reply, &request) != ET_OK)
        return 0;
    memset(&s, 0, sizeof s);
    net_file.net = net;
    net_file.weights = data;
    net_file.frame = frame;
    net_file.options = et_som_defaults();
    s.fit = fit;
    s.options = options;
    s.frame = frame;
    return et_json_write_net(net_path, &net_file, NULL) == ET_OK && et_json_write_surface(surface_path, &s, NULL) == ET_OK
           && et_cloud_write(cloud_path, cloud, CLOUD, ET_CLOUD_PLY_ASCII, NULL) == ET_OK;
}

/* ---- the calls: `out` is memory filled with a pattern, which a failure has to leave alone ------------------------------------ */

static et_status curve_new(void *o) { return et_curve_new(o, 3, 8, 1); }
static et_status curve_copy(void *o) { return et_curve_copy(o, &arc); }
static et_status curve_insert(void *o) { return et_curve_insert(o, &arc, 0.375, 2); }
static et_status curve_elevate(void *o) { return et_curve_elevate(o, &arc, 2); }
static et_status surface_new(void *o) { return et_surface_new(o, 2, 2, 4, 5, 1); }
static et_status surface_copy(void *o) { return et_surface_copy(o, &sheet); }
static et_status surface_insert(void *o) { return et_surface_insert(o, &sheet, ET_ALONG_V, 0.375, 2); }
static et_status surface_elevate(void *o) { return et_surface_elevate(o, &sheet, ET_ALONG_U, 1); }
static et_status exact_curve_insert(void *o) { return et_exact_curve_insert(o, &arc, 0.375, 2); }
static et_status exact_curve_elevate(void *o) { return et_exact_curve_elevate(o, &arc, 1); }
static et_status exact_surface_insert(void *o) { return et_exact_surface_insert(o, &sheet, ET_ALONG_U, 0.375, 1); }
static et_status exact_surface_elevate(void *o) { return et_exact_surface_elevate(o, &sheet, ET_ALONG_V, 1); }
static void free_curve(void *o) { et_curve_free(o); }
static void free_surface(void *o) { et_surface_free(o); }

typedef struct { et_curve c; size_t removed; } curve_removal;
typedef struct { et_surface s; size_t removed; } surface_removal;
static et_status curve_remove(void *o) { curve_removal *r = o; return et_curve_remove(&r->c, &r->removed, &arc, 0.5, 2, 10); }
static et_status surface_remove(void *o) { surface_removal *r = o; return et_surface_remove(&r->s, &r->removed, &sheet, ET_ALONG_U, 0.5, 2, 10); }
static et_status exact_curve_remove(void *o) { curve_removal *r = o; return et_exact_curve_remove(&r->c, &r->removed, &arc, 0.5, 2); }
static et_status exact_surface_remove(void *o) { surface_removal *r = o; return et_exact_surface_remove(&r->s, &r->removed, &sheet, ET_ALONG_V, 0.5, 2); }
static void free_curve_removal(void *o) { et_curve_free(&((curve_removal *)o)->c); }
static void free_surface_removal(void *o) { et_surface_free(&((surface_removal *)o)->s); }

static et_status surface_grid(void *o) { return et_surface_grid(o, &sheet, arc.u, 12, arc.u, 12); }
static et_status exact_surface_grid(void *o) { return et_exact_surface_grid(o, &sheet, arc.u, 4, arc.u, 4); }
static et_status rng_new(void *o) { return et_rng_new(o, 7); }
static void free_rng(void *o) { et_rng_free(*(et_rng **)o); }
static et_status shell_new(void *o) { return et_shell_new(o, 2, 2, net, 1); }
static et_status shell_copy(void *o) { return et_shell_copy(o, &fit.shell); }
static void free_shell(void *o) { et_shell_free(o); }

static et_status quality(void *o) { return et_quality_of(o, data, NOV, net, cloud, CLOUD); }
static et_status exact_quality(void *o) { return et_exact_quality_of(o, data, NOV, net, cloud, 20, NULL); }

/* What a fit fails with stands at the end of its message, and where at the beginning. */
static et_status said(void *o, const et_fit_options *with)
{
    static const char *const places[] = { "parameters: ", "bottom view", "top view", "both views" };
    et_message m = { "" };
    const et_status status = et_fit_make(o, data, NOV, net, with, &m);
    const char *text = et_status_text(status);
    const size_t n = strlen(m.text), k = strlen(text);
    int ok = strcmp(m.text, text) == 0;

    for (size_t p = 0; p < 4; p++)
        if (strncmp(m.text, places[p], strlen(places[p])) == 0)
            ok = (n > k && strcmp(m.text + n - k, text) == 0) || strstr(m.text, ": no memory for ") != NULL;
    return status == ET_OK || ok || (way == SIZES && status == ET_EFORMAT) ? status : ET_ENOCONV;
}

static et_status fit_as(void *o, et_fit_approach approach, et_linalg_method algebra)
{
    et_fit_options with = options;

    with.approach = approach;
    with.algebra = algebra;
    return said(o, &with);
}
static et_status fit_conventional(void *o) { return fit_as(o, ET_FIT_CONVENTIONAL, ET_LINALG_QR); }
static et_status fit_improved(void *o) { return fit_as(o, ET_FIT_IMPROVED, ET_LINALG_QR); }
static et_status fit_joint(void *o) { return fit_as(o, ET_FIT_JOINT, ET_LINALG_QR); }
static et_status fit_cholesky(void *o) { return fit_as(o, ET_FIT_JOINT, ET_LINALG_CHOLESKY); }
static et_status fit_svd(void *o) { return fit_as(o, ET_FIT_JOINT, ET_LINALG_SVD); }
static et_status fit_improved_cholesky(void *o) { return fit_as(o, ET_FIT_IMPROVED, ET_LINALG_CHOLESKY); }
static et_status fit_parameters(void *o) { return et_fit_parameters(o, data, NOV, net, ET_FIT_CONVENTIONAL, ET_PARAM_CENTRIPETAL); }
static et_status exact_fit_parameters(void *o) { return et_exact_fit_parameters(o, data, NOV, net, ET_FIT_IMPROVED, ET_PARAM_CHORD, NULL); }
static et_status fit_exact(void *o) { return et_exact_fit_make(o, data, NOV, net, &options, NULL, NULL, NULL); }
static et_status fit_conventional_corners(void *o)
{
    et_fit_options with = options;

    with.approach = ET_FIT_CONVENTIONAL;
    with.corners = ET_CORNERS_INTERPOLATED;
    return said(o, &with);
}
static void free_fit(void *o) { et_fit_free(o); }
static et_status fit_measure(void *o) { return et_fit_measure(o, reals, NOV, &fit, data); }
static et_status exact_fit_measure(void *o) { return et_exact_fit_measure(o, reals, NOV, &fit, data, NULL); }
static et_status seam_gap(void *o) { return et_seam_gap(o, &fit.shell, 3); }
static et_status exact_seam_gap(void *o) { return et_exact_seam_gap(o, &fit.shell, 3); }
static et_status enclosure_make(void *o) { return et_enclosure_make(o, &fit, data, NOV, &options, NULL); }
static et_status enclosure_refine(void *o) { return et_enclosure_refine(&worked, o, data, NOV, &options, NULL); }
static void free_enclosure(void *o) { et_enclosure_free(o); }
static et_status param_grid(void *o)
{
    size_t *flat = o;

    return et_param_grid(reals, SIDE, reals + SIDE, SIDE, flat, data, ET_PARAM_CHORD);
}
static et_status lsq(size_t *rank, et_linalg_method method, double last)
{
    static double A[] = { 1, 0, 1, 1, 1, 2, 1, 3 };
    static const double B[] = { 1, 2, 3, 5 };

    for (size_t i = 0; i < 4; i++)
        A[2 * i + 1] = last * (double)i + 1;
    return et_linalg_lsq(reals, rank, A, 4, 2, B, 1, method);
}
static et_status linalg_lsq(void *o) { return lsq(o, ET_LINALG_QR, 1); }
static et_status linalg_cholesky(void *o) { return lsq(o, ET_LINALG_CHOLESKY, 1); }
static et_status linalg_svd(void *o) { return lsq(o, ET_LINALG_SVD, 0); }
/* Deficient: the rank is what is wanted. */
static et_status deficient(et_status status) { return status == ET_ERANK ? ET_OK : status; }
static et_status linalg_deficient_qr(void *o) { return deficient(lsq(o, ET_LINALG_QR, 0)); }
static et_status band(size_t *rank, et_linalg_method method)
{
    static const double a[] = { 1, 1, 0, 0, 0, 0, 1, 1 }, B[] = { 1, 2, 3, 5 };
    static const size_t start[] = { 0, 0, 1, 1 };

    return et_linalg_band_lsq(reals, rank, a, start, 4, 3, 2, B, 1, method);
}
static et_status band_deficient(void *o) { return deficient(band(o, ET_LINALG_QR)); }
static et_status band_svd(void *o) { return band(o, ET_LINALG_SVD); }
static et_status linalg_qr(void *o)
{
    static const double A[] = { 1, 0, 1, 1, 1, 2, 1, 3 }, B[] = { 1, 2, 3, 5 };
    (void)o;

    return et_linalg_qr(reals, reals + 4, A, 4, 2, B, 1);
}
static et_status knotrule(void *o) { return et_knotrule_make(o, 9, 2, fit.s[0], SIDE, ET_KNOTRULE_FAITHFUL); }
static et_status exact_param_row(void *o)
{
    return et_exact_param_row(reals, SIDE, o, data, 1, ET_PARAM_CENTRIPETAL, NULL);
}
static et_status exact_param_grid(void *o)
{
    return et_exact_param_grid(reals, SIDE, reals + SIDE, SIDE, o, data, ET_PARAM_CHORD, NULL);
}
static et_status exact_fit_curve(void *o)
{
    static const double t[] = { 0, 0.1, 0.2, 0.4, 0.5, 0.5, 0.6, 0.7, 0.8, 0.9, 1 };

    return et_exact_fit_curve(points, 8, o, arc.u, 12, 3, t, data, 11);
}

static et_status exact_fit_grid(void *o)
{
    return et_exact_fit_grid(points, 4, 4, o, fit.shell.view[0].u, 2, fit.shell.view[0].v, 2, fit.s[0], SIDE, fit.r[0], SIDE, data, 1);
}
static et_status exact_fit_scattered(void *o)
{
    static const double u[] = { 0, 0, 0.5, 1, 1 }, a[] = { 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 0.25 }, b[] = { 0, 0.5, 1, 0, 0.5, 1, 0, 0.5, 1, 0.75 };

    return et_exact_fit_scattered(points, 3, 3, o, u, 1, u, 1, a, b, data, 10);
}
static et_status exact_knotrule(void *o) { return et_exact_knotrule_make(o, 9, 2, fit.s[0], SIDE, ET_KNOTRULE_FAITHFUL); }
static et_status exact_basis(void *o) { return et_exact_basis_ders(o, 2, arc.u, 12, 3, 4, 0.3); }
static et_status exact_curve_ders(void *o) { return et_exact_curve_ders(o, 2, &arc, 0.3); }
static et_status exact_curve_side(void *o) { return et_exact_curve_ders_side(o, 2, &arc, 0.5, ET_SIDE_LEFT); }
static et_status exact_surface_ders(void *o) { return et_exact_surface_ders(o, 2, &sheet, 0.3, 0.7); }
static et_status exact_curve_nearest(void *o) { return et_exact_curve_nearest(o, reals, reals + 1, &arc, cloud[0]); }
static et_status exact_surface_nearest(void *o) { return et_exact_surface_nearest(o, reals, reals + 1, &sheet, cloud[0]); }
static et_status exact_surface_error(void *o) { return et_exact_surface_error(o, reals, &sheet, arc.u, 4, arc.u, 4, data); }
static et_status exact_partials(void *o) { return et_exact_surface_partials(o, 2, &sheet, 0.5, 0.5, ET_SIDE_LEFT, ET_SIDE_RIGHT); }
static et_status exact_normal(void *o) { return et_exact_surface_normal(o, &sheet, 0.3, 0.4); }
static et_status exact_greville(void *o) { return et_exact_knots_greville(o, 8, arc.u, 12, 3); }
static et_status som_train(void *o)
{
    et_som_options with = et_som_defaults();

    with.iterations = 50;
    return et_som_train(points, NOV, o, net, cloud, CLOUD, &with, rng, NULL);
}
static et_status ceres(void *o, int full)
{
    et_ceres_options with = et_ceres_defaults();

    with.iterations = 2;
    return full ? et_ceres_full(&worked, reals, o, NULL, 0, data, NOV, &with, NULL, NULL)
                : et_ceres_points(&worked, o, NULL, 0, data, NOV, &with, NULL, NULL);
}
static et_status ceres_points(void *o) { return ceres(o, 0); }
static et_status ceres_full(void *o) { return ceres(o, 1); }
static et_status vectors(void *o) { return et_vectors_read(o, vectors_path, NULL); }
static void free_vectors(void *o) { et_vectors_free(o); }
static et_status net_write(void *o) { (void)o; return et_json_write_net(out_path, &net_file, NULL); }

static et_status objective_new(void *o) { return et_objective_new(o, &fit, data, NOV); }
static void free_objective(void *o) { et_objective_free(*(et_objective **)o); }
static et_status search_start(void *o)
{
    const et_search_options s = et_search_defaults();
    static const double x0[6] = { 0 };

    return et_search_start(o, x0, 6, &s, 1, value, NULL, rng);
}
static void free_search(void *o) { et_search_free(o); }
static et_status search_run(et_search_step step)
{
    size_t made;

    return et_search_run(&search, &made, NULL, 2, step, rng, NULL);
}
static et_status ga_step(void *o) { (void)o; return search_run(et_ga_step); }
static et_status de_step(void *o) { (void)o; return search_run(et_de_step); }
static et_status pso_step(void *o) { (void)o; return search_run(et_pso_step); }
static et_status optimum(void *o) { return et_optimum_find(&worked, o, points, NULL, 0, data, NOV, NULL, NULL, NULL); }
/* All parameters in the first quarter of the domain: not every control point is determined. */
static et_status optimum_bunched(void *o)
{
    static double near[2][SIDE];
    const et_fit was = worked;

    for (size_t i = 0; i < net.nx; i++)
        near[0][i] = 0.25 * fit.s[0][i];
    for (size_t j = 0; j < net.ny; j++)
        near[1][j] = 0.25 * fit.r[0][j];
    worked.s[0] = worked.s[1] = near[0];
    worked.r[0] = worked.r[1] = near[1];
    const et_status status = et_optimum_find(&worked, o, points, NULL, 0, data, NOV, NULL, NULL, NULL);
    memcpy(worked.s, was.s, sizeof was.s);
    memcpy(worked.r, was.r, sizeof was.r);
    return status;
}
static et_status optimum_bound(void *o) { return et_optimum_bound(o, data, NOV, &fit, data); }

static et_status cloud_read(void *o) { return et_cloud_read(o, cloud_path, NULL); }
static void free_cloud(void *o) { et_cloud_free(o); }
/* The same cloud in other formats. */
static const struct { const char *suffix, *text; } files[] = {
    { "csv", "x,y,z\n1,2,3\n4,5,6\n7,8,9\n" }, { "obj", "v 1 2 3\nv 4 5 6\nv 7 8 9\nf 1 2 3\n" },
    { "stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n" },
    { "pcd", "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n" } };
enum { FILES = sizeof files / sizeof files[0] };
static char file_path[FILES][256];

static int make_files(const char *folder)
{
    for (size_t k = 0; k < FILES; k++) {
        FILE *f;
        snprintf(file_path[k], sizeof file_path[k], "%s/cloud.%s", folder, files[k].suffix);
        f = fopen(file_path[k], "wb");
        if (!f || fputs(files[k].text, f) < 0 || fclose(f) != 0)
            return 0;
    }
    return 1;
}
static et_status csv_read(void *o) { return et_cloud_read(o, file_path[0], NULL); }
static et_status obj_read(void *o) { return et_cloud_read(o, file_path[1], NULL); }
static et_status stl_read(void *o) { return et_cloud_read(o, file_path[2], NULL); }
static et_status pcd_read(void *o) { return et_cloud_read(o, file_path[3], NULL); }
static et_status cloud_write(void *o) { (void)o; return et_cloud_write(out_path, cloud, CLOUD, ET_CLOUD_XYZ, NULL); }
static et_status net_read(void *o) { return et_json_read_net(o, net_path, NULL); }
static void free_net(void *o) { et_json_free_net(o); }
static et_status surface_read(void *o) { return et_json_read_surface(o, surface_path, NULL); }
static void free_surface_file(void *o) { et_json_free_surface(o); }
static et_status iges(void *o) { (void)o; return et_iges_write(out_path, &fit.shell, &frame, NULL); }
static et_status tessellation(void *o) { return et_tessellation_of(o, &fit.shell, &frame, 5, 6); }
static void free_tessellation(void *o) { et_tessellation_free(o); }

static et_status request_copy(void *o) { return et_request_copy(o, &request); }
static et_status request_new(void *o) { return et_request_new(o, ET_OP_SURFACE_ERROR); }
static et_status request_print(void *o) { return et_request_print(o, &request); }
static et_status request_parse(void *o)
{
    return et_request_parse(o, "fit_curve 1 4 0 0 1 1 3 0 0x1p-1 1 3 0 0 0 1 1 1 2 2 2", NULL);
}
static et_status reply_parse(void *o)
{
    uint64_t id;

    return et_reply_parse(o, &id, "7 ok 1 2 3 4 0x1p-3 5 6 7 8 9 10 11 12 13 14 15 16 17", NULL);
}
static et_status reply_print(void *o) { return et_reply_print(o, 1, &reply); }
static void free_request(void *o) { et_request_free(o); }
static void free_reply(void *o) { et_reply_free(o); }
static void free_text(void *o) { free(*(char **)o); }
static et_status answer_fast(void *o) { return et_answer_fast(o, &request); }
static et_status answer_exact(void *o) { return et_answer_exact(o, &request); }
static et_status truth(void *o) { return et_judge_truth(o, &request); }
static void free_truth(void *o) { et_judge_free(o); }
static et_truth known;                    /* of request, with its right answer, which is judged as it is and with its last number another */
static et_reply right;
static et_status judge(void *o)
{
    et_status status = et_judge_reply(o, &request, &known, &right);

    if (status == ET_OK && right.count > 0) {
        et_judgement other;
        right.x[right.count - 1] += 0.125;
        status = et_judge_reply(&other, &request, &known, &right);
        right.x[right.count - 1] -= 0.125;
        if (status == ET_OK)
            memcpy(o, &other, sizeof other);
        else
            memset(o, 0x5a, sizeof other);
    }
    return status;
}

static et_category category = ET_CATEGORY_PLAIN;
static et_status draw(void *o)
{
    const et_hello all = et_answer_hello(1);

    return et_campaign_draw(o, request.op, category, 3, 5, &all);
}
static et_status vary(void *o)
{
    const et_hello all = et_answer_hello(1);

    return et_campaign_vary(o, &request, 3, 5, &all);
}

static int no_points(void *context, const et_request *r)
{
    (void)context;
    return r->arg[0].count > 0;
}
static et_status shrink(void *o)
{
    et_request r;
    et_status status = et_request_copy(&r, &request);

    if (status != ET_OK)
        return status;
    status = et_campaign_shrink(&r, no_points, NULL, 20);
    if (status == ET_OK)
        memcpy(o, &r, sizeof r);
    else
        et_request_free(&r);
    return status;
}

static et_status asked(void *context, et_reply *answer, const et_request *r)
{
    (void)context;
    return et_answer_fast(answer, r);
}
static size_t relation;
typedef struct { et_judgement judgement; et_request request; } related;
static et_status relate(void *o)
{
    const et_hello all = et_answer_hello(0);
    related *r = o;

    const et_status status = et_campaign_relate(&r->judgement, &r->request, relation, 1, 1, &all, asked, NULL);
    /* Without memory some relations cannot be decided; none is then broken. */
    return status == ET_OK && et_judge_bad(r->judgement.verdict) ? ET_EINTERNAL : status;
}
static void free_related(void *o) { et_request_free(&((related *)o)->request); }

/* A table that answers spans one too high is judged: questions, verdicts, shrinking, what is told. */
static et_status one_too_high(void *context, et_reply *answer, const et_request *r)
{
    const et_status status = et_answer_fast(answer, r);

    (void)context;
    if (status == ET_OK && r->op == ET_OP_SPAN && answer->count > 0)
        answer->x[0] += 1;
    return status;
}
static et_status conform(void *o)
{
    const et_peer_table table = { et_answer_hello(0), one_too_high, NULL };
    et_conform_options with = et_conform_defaults();
    et_conform_report report;
    et_peer *peer;
    et_status status = et_peer_wrap(&peer, &table);

    memset(with.op, 0, sizeof with.op);
    with.op[ET_OP_SPAN] = with.op[ET_OP_CURVE_POINT] = 1;
    with.level = 2;
    with.cases = 8;
    with.findings = 1;
    if (status == ET_OK) {
        status = et_conform_run(&report, peer, &with, NULL, NULL);
        et_peer_stop(peer);
        if (status == ET_OK)
            memcpy(o, &report, sizeof report);
        else
            et_conform_free(&report);     /* a report goes as far as it went */
    }
    return status;
}
static void free_conform(void *o) { et_conform_free(o); }

/* Vectors, the second of which is not right, relations between answers, and worse cases sought. */
static et_status levels(void *o)
{
    static const char page[] = "{\"format\": \"etalon-conformance\", \"version\": 1, \"operation\": \"net_counts\", \"vectors\": ["
        "{\"id\": \"net_counts/plain/1\", \"category\": \"plain\", \"validity\": \"valid\", \"request\": \"2 2\", \"want\": [\"8\", \"4\", \"4\"], "
        "\"bound\": [\"0x0p+0\", \"0x0p+0\", \"0x0p+0\"], \"condition\": \"0x1p+0\"},"
        "{\"id\": \"net_counts/plain/2\", \"category\": \"plain\", \"validity\": \"valid\", \"request\": \"2 2\", \"want\": [\"9\", \"4\", \"4\"], "
        "\"bound\": [\"0x0p+0\", \"0x0p+0\", \"0x0p+0\"], \"condition\": \"0x1p+0\", \"issue\": \"https://a\"}]}";
    et_peer_table table = { et_answer_hello(0), one_too_high, NULL };
    et_conform_options with = et_conform_defaults();
    et_conform_report report;
    et_peer *peer;

    memset(table.hello.op, 0, sizeof table.hello.op);
    table.hello.op[ET_OP_NET_COUNTS] = table.hello.op[ET_OP_NET_CLASS] = 1;
    memset(with.op, 0, sizeof with.op);
    with.op[ET_OP_NET_COUNTS] = with.op[ET_OP_NET_CLASS] = 1;
    with.level = 3;
    with.cases = 1;
    with.vectors = folder_path;
    with.findings = 1;
    if (!put("net_counts.json", page) || !put("schema.json", "{}"))
        return ET_EIO;
    et_status status = et_peer_wrap(&peer, &table);
    if (status == ET_OK) {
        status = et_conform_run(&report, peer, &with, NULL, NULL);
        et_peer_stop(peer);
        if (status == ET_OK)
            memcpy(o, &report, sizeof report);
        else
            et_conform_free(&report);
    }
    return status;
}

/* A program, and what it answers; its hello comes in two parts. */
static const et_peer_program echoing = { "read l; printf '0 ok '; sleep 0.03; echo 'protocol=1 name=a version=1 ops=net_counts'; read id rest; echo \"$id ok 1\"",
                                         60, NULL, NULL, NULL };
static et_status peer_start(void *o)
{
    et_message text;
    et_asked how;

    return et_peer_start(o, &how, &echoing, &text);
}
static void stop_peer(void *o) { et_peer_stop(*(et_peer **)o); }
static et_status peer_ask(void *o)
{
    et_message text;
    et_asked how;
    et_peer *peer;
    et_status status = et_peer_start(&peer, &how, &echoing, &text);

    if (status != ET_OK)
        return status;
    status = et_peer_ask(peer, &how, o, &request, &text);
    et_peer_stop(peer);
    return status;
}

/* harmless: it may do without (a block that is not made smaller). */
static const struct { const char *name; et_status (*call)(void *out); void (*release)(void *out); size_t size; int harmless; } calls[] = {
    { "curve_new", curve_new, free_curve, sizeof(et_curve), 0 }, { "curve_copy", curve_copy, free_curve, sizeof(et_curve), 0 },
    { "curve_insert", curve_insert, free_curve, sizeof(et_curve), 0 }, { "curve_elevate", curve_elevate, free_curve, sizeof(et_curve), 0 },
    { "curve_remove", curve_remove, free_curve_removal, sizeof(curve_removal), 0 }, { "surface_new", surface_new, free_surface, sizeof(et_surface), 0 },
    { "surface_copy", surface_copy, free_surface, sizeof(et_surface), 0 }, { "surface_insert", surface_insert, free_surface, sizeof(et_surface), 0 },
    { "surface_elevate", surface_elevate, free_surface, sizeof(et_surface), 0 },
    { "surface_remove", surface_remove, free_surface_removal, sizeof(surface_removal), 0 },
    { "exact_curve_insert", exact_curve_insert, free_curve, sizeof(et_curve), 0 }, { "exact_curve_elevate", exact_curve_elevate, free_curve, sizeof(et_curve), 0 },
    { "exact_curve_remove", exact_curve_remove, free_curve_removal, sizeof(curve_removal), 0 },
    { "exact_surface_insert", exact_surface_insert, free_surface, sizeof(et_surface), 0 },
    { "exact_surface_elevate", exact_surface_elevate, free_surface, sizeof(et_surface), 0 },
    { "exact_surface_remove", exact_surface_remove, free_surface_removal, sizeof(surface_removal), 0 },
    { "surface_grid", surface_grid, NULL, 144 * sizeof(et_vec3), 0 }, { "exact_surface_grid", exact_surface_grid, NULL, 16 * sizeof(et_vec3), 0 },
    { "rng_new", rng_new, free_rng, sizeof(et_rng *), 0 }, { "shell_new", shell_new, free_shell, sizeof(et_shell), 0 },
    { "shell_copy", shell_copy, free_shell, sizeof(et_shell), 0 }, { "quality_of", quality, NULL, sizeof(et_som_quality), 0 },
    { "exact_quality_of", exact_quality, NULL, sizeof(et_som_quality), 0 }, { "fit_make conventional", fit_conventional, free_fit, sizeof(et_fit), 0 },
    { "fit_make improved", fit_improved, free_fit, sizeof(et_fit), 0 }, { "fit_make joint", fit_joint, free_fit, sizeof(et_fit), 0 },
    { "fit_make joint, cholesky", fit_cholesky, free_fit, sizeof(et_fit), 0 }, { "fit_make joint, svd", fit_svd, free_fit, sizeof(et_fit), 0 },
    { "fit_make improved, cholesky", fit_improved_cholesky, free_fit, sizeof(et_fit), 0 },
    { "fit_parameters", fit_parameters, free_fit, sizeof(et_fit), 0 }, { "exact_fit_parameters", exact_fit_parameters, free_fit, sizeof(et_fit), 0 },
    { "knotrule_make", knotrule, NULL, 12 * sizeof(double), 0 }, { "exact_knotrule_make", exact_knotrule, NULL, 12 * sizeof(double), 0 },
    { "exact_param_row", exact_param_row, NULL, sizeof(int), 0 }, { "exact_param_grid", exact_param_grid, NULL, sizeof(size_t), 0 },
    { "linalg_lsq cholesky", linalg_cholesky, NULL, sizeof(size_t), 0 }, { "linalg_lsq svd", linalg_svd, NULL, sizeof(size_t), 0 },
    { "linalg_lsq deficient", linalg_deficient_qr, NULL, sizeof(size_t), 0 },
    { "linalg_band_lsq deficient", band_deficient, NULL, sizeof(size_t), 0 }, { "linalg_band_lsq svd", band_svd, NULL, sizeof(size_t), 0 },
    { "linalg_qr", linalg_qr, NULL, 0, 0 }, { "exact_basis_ders", exact_basis, NULL, 12 * sizeof(double), 0 },
    { "exact_curve_ders", exact_curve_ders, NULL, 3 * sizeof(et_vec3), 0 }, { "exact_curve_ders_side", exact_curve_side, NULL, 3 * sizeof(et_vec3), 0 },
    { "exact_surface_ders", exact_surface_ders, NULL, 6 * sizeof(et_vec3), 0 },
    { "ceres_points", ceres_points, NULL, sizeof(et_ceres_summary), 0 }, { "ceres_full", ceres_full, NULL, sizeof(et_ceres_summary), 0 },
    { "cloud_read csv", csv_read, free_cloud, sizeof(et_cloud), 1 }, { "cloud_read obj", obj_read, free_cloud, sizeof(et_cloud), 1 },
    { "cloud_read stl", stl_read, free_cloud, sizeof(et_cloud), 1 }, { "cloud_read pcd", pcd_read, free_cloud, sizeof(et_cloud), 1 },
    { "campaign_shrink", shrink, free_request, sizeof(et_request), 1 }, { "campaign_relate", relate, free_related, sizeof(related), 1 },
    { "conform_run", conform, free_conform, sizeof(et_conform_report), 0 }, { "conform_run levels", levels, free_conform, sizeof(et_conform_report), 1 },
    { "peer_start", peer_start, stop_peer, sizeof(et_peer *), 0 }, { "peer_ask", peer_ask, free_reply, sizeof(et_reply), 0 },
    { "fit_make conventional, corners", fit_conventional_corners, free_fit, sizeof(et_fit), 0 }, { "exact_fit_make", fit_exact, free_fit, sizeof(et_fit), 0 },
    { "fit_measure", fit_measure, NULL, sizeof(et_fit_error), 0 }, { "exact_fit_measure", exact_fit_measure, NULL, sizeof(et_fit_error), 0 },
    { "seam_gap", seam_gap, NULL, sizeof(et_seam), 1 }, { "exact_seam_gap", exact_seam_gap, NULL, sizeof(et_seam), 0 },
    { "enclosure_make", enclosure_make, free_enclosure, sizeof(et_enclosure), 0 },
    { "enclosure_refine", enclosure_refine, free_enclosure, sizeof(et_enclosure), 0 }, { "param_grid", param_grid, NULL, sizeof(size_t), 0 },
    { "linalg_lsq", linalg_lsq, NULL, sizeof(size_t), 0 }, { "exact_fit_curve", exact_fit_curve, NULL, sizeof(et_exact_lsq), 0 },
    { "exact_fit_grid", exact_fit_grid, NULL, sizeof(et_exact_lsq), 0 }, { "exact_fit_scattered", exact_fit_scattered, NULL, sizeof(et_exact_lsq), 0 },
    { "exact_curve_nearest", exact_curve_nearest, NULL, sizeof(double), 0 },
    { "exact_surface_nearest", exact_surface_nearest, NULL, 2 * sizeof(double), 0 },
    { "exact_surface_error", exact_surface_error, NULL, sizeof(double), 0 }, { "exact_surface_partials", exact_partials, NULL, 6 * sizeof(et_vec3), 0 },
    { "exact_surface_normal", exact_normal, NULL, sizeof(et_vec3), 0 }, { "exact_knots_greville", exact_greville, NULL, 8 * sizeof(double), 0 },
    { "som_train", som_train, NULL, sizeof(et_som_quality), 0 }, { "vectors_read", vectors, free_vectors, sizeof(et_vectors), 0 },
    { "json_write_net", net_write, NULL, 0, 0 },
    { "objective_new", objective_new, free_objective, sizeof(et_objective *), 0 }, { "search_start", search_start, free_search, sizeof(et_search), 0 },
    { "ga_step", ga_step, NULL, 0, 0 }, { "de_step", de_step, NULL, 0, 0 }, { "pso_step", pso_step, NULL, 0, 0 },
    { "optimum_find", optimum, NULL, sizeof(et_optimum_result), 0 }, { "optimum_find bunched", optimum_bunched, NULL, sizeof(et_optimum_result), 0 },
    { "optimum_bound", optimum_bound, NULL, sizeof(double), 0 },
    { "cloud_read", cloud_read, free_cloud, sizeof(et_cloud), 1 }, { "cloud_write", cloud_write, NULL, 0, 0 },
    { "json_read_net", net_read, free_net, sizeof(et_net_file), 0 }, { "json_read_surface", surface_read, free_surface_file, sizeof(et_surface_file), 0 },
    { "iges_write", iges, NULL, 0, 0 }, { "tessellation_of", tessellation, free_tessellation, sizeof(et_tessellation), 0 },
    { "request_new", request_new, free_request, sizeof(et_request), 0 }, { "request_copy", request_copy, free_request, sizeof(et_request), 0 },
    { "request_print", request_print, free_text, sizeof(char *), 0 }, { "request_parse", request_parse, free_request, sizeof(et_request), 0 },
    { "reply_parse", reply_parse, free_reply, sizeof(et_reply), 0 }, { "reply_print", reply_print, free_text, sizeof(char *), 0 },
    { "answer_fast", answer_fast, free_reply, sizeof(et_reply), 0 }, { "answer_exact", answer_exact, free_reply, sizeof(et_reply), 0 },
    { "judge_truth", truth, free_truth, sizeof(et_truth), 0 }, { "campaign_draw", draw, free_request, sizeof(et_request), 0 },
    { "campaign_vary", vary, free_request, sizeof(et_request), 0 }, { "judge_reply", judge, NULL, sizeof(et_judgement), 0 } };
enum { CALLS = sizeof calls / sizeof calls[0], PATTERN = 0x5a };

/* ---- the runs ------------------------------------------------------------------------------------------------------------------ */

static int is_pattern(const unsigned char *p, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (p[k] != PATTERN)
            return 0;
    return 1;
}

/* worked is fit again, and a search is at its start. */
static int fresh(void)
{
    static int made;

    refuse_at = 0;
    if (made) {
        et_shell_free(&worked.shell);
        et_search_free(&search);
    }
    made = 1;
    worked = fit;
    return et_shell_copy(&worked.shell, &fit.shell) == ET_OK && search_start(&search) == ET_OK;
}

static int as_it_was(void)
{
    for (size_t w = 0; w < 2; w++)
        if (memcmp(worked.shell.view[w].points, fit.shell.view[w].points, 16 * sizeof(et_vec3)) != 0)
            return 0;
    return 1;
}

/* What is wrong with call k when request `at` is refused; null if nothing.  *end: it did not come to that request. */
static const char *run(size_t k, size_t at, int *end)
{
    static unsigned char out[ROOM];
    size_t before;
    et_status status;

    memset(out, PATTERN, sizeof out);
    if (!fresh())
        return "the test itself has no memory";
    before = live;
    requests = 0;
    refuse_at = at;
    status = calls[k].call(out);
    refuse_at = 0;
    *end = requests < at;
    if (status == ET_OK && calls[k].release)
        calls[k].release(out);
    /* What ceres_full succeeded with is rational, so it has weights. */
    if (live != before && !(status == ET_OK && strcmp(calls[k].name, "ceres_full") == 0))
        return "memory is kept";
    if (*end)
        return status == ET_OK ? NULL : "fails although it got all memory it asked for";
    /* Whether scattered data determine a fit is asked twice: exactly, and by the fit itself. */
    if (status == ET_OK && (calls[k].harmless || ((calls[k].call == answer_fast || calls[k].call == vary) && request.op == ET_OP_FIT_SCATTERED)))
        return NULL;
    /* A net of a size that is no number is none; a surface whose is none is not valid. */
    if (way == SIZES && (status == ET_EINVAL || status == ET_EFORMAT))
        status = ET_ENOMEM;
    if (status != ways[way].status)
        return status == ET_OK ? "says ET_OK" : "says the wrong thing";
    if (!is_pattern(out, sizeof out))
        return "an output was changed";
    return as_it_was() ? NULL : "what it should have changed at the end is changed";
}

static size_t tried;
static const char *only;                 /* the one call to try; null: all */

/* C++ has its own sizes; the protocol answers that such a request is none. */
static int sized(const char *name)
{
    static const char *const others[] = { "ceres", "request", "reply", "answer", "judge", "campaign", "conform", "vectors", "peer" };

    for (size_t k = 0; k < sizeof others / sizeof others[0]; k++)
        if (strncmp(name, others[k], strlen(others[k])) == 0)
            return 0;
    return 1;
}

static int try(size_t k, const char *what)
{
    const char *why = NULL;
    size_t at = 0;

    if ((only && strcmp(only, calls[k].name) != 0) || (way != MEMORY && !sized(calls[k].name)))
        return 1;
    fflush(stdout);
    for (int end = 0; !why && !end;)
        why = run(k, ++at, &end);
    tried++;
    if (why)
        printf("FAIL memory %s %s%s: %s, request %zu refused\n", calls[k].name, what, ways[way].name, why, at);
    else
        printf("ok memory %s %s%s: %zu requests\n", calls[k].name, what, ways[way].name, at - 1);
    return why == NULL;
}

/* What judge is given. */
static void learn(void)
{
    et_judge_free(&known);
    et_reply_free(&right);
    if (et_judge_truth(&known, &request) != ET_OK || et_answer_exact(&right, &request) != ET_OK)
        exit(2);
}

/* Weights that may be left out, a removal that is all but exact, a normal of four limits, samples of two surfaces. */
#define FOUR "6 0 0 0x1p-1 0x1p-1 1 1 6 0 0 0x1p-1 0x1p-1 1 1 16 0 0 0 0 0 1 0 0 0 1 0 0 0 1 0 0 1 1 0 0 1 1 0 1 0 0 0 1 0 0 0 0 0 0 1 0 0 1 0 1 1 0 1 0 0 1 1 0 0 "
#define SQUARE "1 1 4 0 0 1 1 4 0 0 1 1 4 0 0 0 0 1 0 1 0 0 1 1 0 4 1 1 1 2 "
static const char *const edges[] = {
    "curve_insert 1 4 0 0 1 1 2 0 0 0 2 0 0 2 3 3 0x1p-1 1",
    "curve_remove 2 7 0 0 0 0x1p-1 1 1 1 4 0 0 0 1 2 0 2 2 0 3 0 1 4 1 1 1 1 0x1p-1 1 0x1p-3",
    "surface_remove 1 1 5 0 0 0x1p-1 1 1 4 0 0 1 1 6 0 0 0 0 1 0 1 0 0 1 1 1 2 0 0 2 1 0 6 1 1 1 1 1 1 u 0x1p-1 1 0x1p-30",
    "surface_normal 1 1 " FOUR "0x1p-1 0x1p-1", "surface_ders 1 1 " FOUR "0x1p-1 0x1p-1 any any 1", "seam_gap " SQUARE SQUARE "1",
    "surface_nearest " SQUARE "1 0 0 1",
};

int main(int argc, char **argv)
{
    size_t passed = 0, failed = 0;

    if (argc < 2 || argc > 3 || !make_all(argv[1]) || !make_files(argv[1]))
        return fputs("memory FOLDER [CALL]: the inputs cannot be made\n", stderr), 2;
    learn();
    only = argc == 3 ? argv[2] : NULL;
    for (size_t k = 0; k < CALLS; k++)
        for (way = MEMORY; way < WAYS; way++)
            failed += try(k, "") ? 0 : 1;
    way = MEMORY;
    for (relation = 1; relation < et_campaign_relations(); relation++)
        for (size_t k = 0; k < CALLS; k++)
            if (strcmp(calls[k].name, "campaign_relate") == 0)
                failed += try(k, et_campaign_relation_name(relation)) ? 0 : 1;
    /* Every operation of the conformance protocol, answered and judged. */
    for (int op = 0; op < ET_OPS; op++) {
        const et_hello all = et_answer_hello(1);
        et_request_free(&request);
        if (et_campaign_draw(&request, (et_request_op)op, ET_CATEGORY_PLAIN, 1, 0, &all) != ET_OK)
            return fputs("memory: no plain case of an operation\n", stderr), 2;
        learn();
        for (size_t k = 0; k < CALLS; k++)
            if (strncmp(calls[k].name, "answer_", 7) == 0 || strncmp(calls[k].name, "judge_", 6) == 0 || strcmp(calls[k].name, "campaign_vary") == 0
                || strcmp(calls[k].name, "campaign_shrink") == 0)
                failed += try(k, et_request_name((et_request_op)op)) ? 0 : 1;
        for (category = ET_CATEGORY_PLAIN; category < ET_CATEGORIES; category++)
            for (size_t k = 0; k < CALLS; k++)
                if (category != ET_CATEGORY_SIZE && et_campaign_has(request.op, category) && strcmp(calls[k].name, "campaign_draw") == 0)
                    failed += try(k, et_campaign_name(category)) ? 0 : 1;
    }
    /* Rational curves and surfaces whose answers have another factor of the weights, and removals and nearest points of them. */
    for (int op = 0; op < ET_OPS; op++) {
        static const et_category with_weights[] = { ET_CATEGORY_WEIGHTS, ET_CATEGORY_EDITING };
        const et_hello all = et_answer_hello(1);
        for (size_t c = 0; c < 2; c++) {
            if (op < ET_OP_CURVE_INSERT || op == ET_OP_SURFACE_NEAREST)
                break;
            et_request_free(&request);
            if (et_campaign_draw(&request, (et_request_op)op, with_weights[c], 1, 3, &all) != ET_OK) {
                memset(&request, 0, sizeof request);
                continue;
            }
            learn();
            if (request.op <= ET_OP_SURFACE_ELEVATE && right.count > 0)
                for (size_t k = 0; k < 2 && right.x[right.count - 1 - k] > 0; k++)
                    right.x[right.count - 1 - k] *= 2;
            for (size_t k = 0; k < CALLS; k++)
                if (strncmp(calls[k].name, "judge_", 6) == 0)
                    failed += try(k, et_campaign_name(with_weights[c])) ? 0 : 1;
        }
    }
    for (size_t c = 0; c < sizeof edges / sizeof *edges; c++) {
        et_request_free(&request);
        if (et_request_parse(&request, edges[c], NULL) != ET_OK)
            return fputs("memory: a request that is none\n", stderr), 2;
        learn();
        /* of the first the weights, which are equal, may be left out */
        if (c == 0) {
            right.count -= 3;
            right.x[right.count - 1] = 0;
        }
        for (size_t k = 0; k < CALLS; k++)
            if (strncmp(calls[k].name, "judge_", 6) == 0)
                failed += try(k, edges[c]) ? 0 : 1;
    }
    passed = tried - failed;
    printf("%zu passed, %zu failed\n", passed, failed);
    return failed > 0;
}
