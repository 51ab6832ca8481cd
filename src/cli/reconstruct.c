/* reconstruct: all steps, from a cloud to a closed surface with its files, pictures and report.
 *
 * Everything is computed, then written into a folder of its own inside the output folder, then moved to its place: a failure or an
 * interruption leaves an earlier result as it was.
 */
#include "cli/cli.h"
#include "etalon/base/size.h"
#include "etalon/io/cloud.h"
#include "etalon/io/iges.h"
#include "etalon/io/plot.h"
#include "etalon/io/tessellation.h"
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { OWN = 6, TABLE = OWN + CLI_TRAIN_OPTIONS + CLI_FIT_OPTIONS + CLI_REFINE_OPTIONS + CLI_COMMON };

typedef struct {
    const char *directory, *refine;
    int no_pictures;
    size_t mesh[2];
    cli_train_options train;
    cli_fit_choice fit;
    cli_refine_options refiner;
    size_t algorithms[CLI_ALGORITHMS], nalgorithms;
} reconstruct_options;

/* ---- computing ------------------------------------------------------------------------------------------------------ */

static et_status fit_all(cli_reconstruction *r, const reconstruct_options *o, cli_run *run, et_message *message)
{
    const double began = cli_cpu();

    for (size_t a = 0; a < 3; a++) {
        et_fit_options options = cli_fit_chosen(&o->fit);
        options.approach = (et_fit_approach)a;
        const et_status status = cli_fit(&r->fit[a], &r->net, &options, run, message);
        if (status != ET_OK)
            return status;
    }
    r->fit_seconds = cli_cpu() - began;
    return ET_OK;
}

static et_status refine_all(cli_reconstruction *r, const reconstruct_options *o, cli_run *run, et_message *message)
{
    r->refined = et_size_array(o->nalgorithms, sizeof *r->refined);
    if (!r->refined)
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    for (size_t k = 0; k < o->nalgorithms; k++) {
        const et_task task = cli_task(run, cli_algorithm_name(o->algorithms[k]));
        const et_status status = cli_refine(&r->refined[k], &r->fit[r->approach], r->net.weights, (cli_algorithm)o->algorithms[k], &o->refiner, run->seed,
                                            0, &task, message);
        cli_task_end(run);
        if (status == ET_OK || status == ET_ESTOPPED)
            r->nrefined++;
        if (status == ET_ESTOPPED)
            return et_status_fail(message, status, "interrupted while refining; nothing was written");
        if (status != ET_OK)
            return status;
        cli_say(run, "%-12s %.9g -> %.9g  (%.2f s)", cli_algorithm_name(o->algorithms[k]), r->refined[k].before, r->refined[k].after,
                r->refined[k].seconds);
    }
    r->best = r->nrefined;
    for (size_t k = 0; k < r->nrefined; k++)
        if (r->best == r->nrefined || r->refined[k].after < r->refined[r->best].after)
            r->best = k;
    return ET_OK;
}

static et_status compute(cli_reconstruction *r, const et_cloud *cloud, const reconstruct_options *o, cli_run *run, et_message *message)
{
    et_status status = cli_train(&r->net, &r->train_seconds, cloud->points, cloud->count, &o->train, run, message);

    if (status != ET_OK)
        return status;
    cli_say(run, "net %zux%zu    QE %.6f  TE %.6f  (%.2f s)", r->net.net.nx, r->net.net.ny, r->net.training.qe, r->net.training.te, r->train_seconds);
    status = fit_all(r, o, run, message);
    if (status != ET_OK)
        return status;
    cli_say(run, "%-12s error %.9g, seam gap %g", cli_approach_name(r->approach), r->fit[r->approach].error.nov, r->fit[r->approach].seam_gap);
    r->overshoot = cli_overshoot(&r->fit[r->approach], r->net.weights);
    cli_warn_overshoot(run, r->overshoot);
    status = cli_check(message);
    return status == ET_OK ? refine_all(r, o, run, message) : status;
}

/* ---- writing -------------------------------------------------------------------------------------------------------- */

/* DIR/name in a buffer of the caller's; make_directory has seen to it that folder, staging folder and name fit. */
enum { PATH = 4096 };
static const char *in(char path[PATH], const char *directory, const char *name)
{
    strcpy(path, directory);
    strcat(path, "/");
    return strcat(path, name);
}

/* *made: 1 if the last folder of the path was not there before. */
static et_status make_directory(int *made, const char *path, et_message *message)
{
    struct stat there;
    char partial[PATH];

    if (strlen(path) + 64 > PATH || !path[0])
        return et_status_fail(message, ET_EINVAL, "--output: '%.64s' is no usable folder name", path);
    strcpy(partial, path);
    for (char *slash = strchr(partial + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(partial, 0777) != 0 && errno != EEXIST)
            return et_status_fail(message, ET_EIO, "cannot make the folder %s: %s", partial, strerror(errno));
        *slash = '/';
    }
    *made = mkdir(path, 0777) == 0;
    if (!*made && errno != EEXIST)
        return et_status_fail(message, ET_EIO, "cannot make the folder %s: %s", path, strerror(errno));
    if (stat(path, &there) != 0 || !S_ISDIR(there.st_mode))
        return et_status_fail(message, ET_EIO, "%s is not a folder", path);
    return ET_OK;
}

/* All that a reconstruction may leave in its folder. */
static const char *const products[] = { "cloud.ply", "net.json", "fit.json", "surface.json", "surface.igs", "surface.obj", "surface.stl", "history.csv",
                                        "summary.json", "report.md", "cloud.png", "net.png", "surface.png", "error.png", "convergence.png" };
enum { PRODUCTS = sizeof products / sizeof products[0] };

/* The staging folder: inside the output folder, so that moving out of it is a rename.  One at a time, known to the handler of signals. */
static char stage[PATH];

/* Only what may be called in a handler. */
static void drop_stage(void)
{
    char path[PATH];

    for (size_t k = 0; k < PRODUCTS; k++)
        unlink(in(path, stage, products[k]));
    rmdir(stage);
}

static et_status open_stage(const char *directory, et_message *message)
{
    in(stage, directory, ".part-XXXXXX");
    if (!mkdtemp(stage))
        return et_status_fail(message, ET_EIO, "cannot make a folder in %s: %s", directory, strerror(errno));
    cli_on_end(drop_stage);
    return ET_OK;
}

/* Runs that publish into one folder do so one after the other.  The lock file is removed while it is held, so whoever waited for it
 * looks whether it is still the one that stands there. */
static int lock_directory(const char *directory, char path[PATH])
{
    struct flock whole;
    struct stat held, there;

    memset(&whole, 0, sizeof whole);
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    for (;;) {
        const int lock = open(in(path, directory, ".lock"), O_RDWR | O_CREAT, 0666);
        if (lock < 0)
            return -1;
        if (fcntl(lock, F_SETLKW, &whole) == 0) {
            if (fstat(lock, &held) == 0 && stat(path, &there) == 0 && held.st_ino == there.st_ino)
                return lock;
        } else if (errno != EINTR || cli_stopped()) {
            close(lock);
            return -1;
        }
        close(lock);
    }
}

/* What was not made this time is removed: a picture of an earlier run must not stand beside this one's numbers. */
static et_status move_all(const char *directory, et_message *message)
{
    char from[PATH], to[PATH];
    struct stat there;

    for (size_t k = 0; k < PRODUCTS; k++)
        if (stat(in(to, directory, products[k]), &there) == 0 && S_ISDIR(there.st_mode))
            return et_status_fail(message, ET_EIO, "cannot write %s: a folder stands there", to);
    for (size_t k = 0; k < PRODUCTS; k++)
        if (rename(in(from, stage, products[k]), in(to, directory, products[k])) != 0
            && !(errno == ENOENT && (unlink(to) == 0 || errno == ENOENT)))
            return et_status_fail(message, ET_EIO, "cannot write %s: %s", to, strerror(errno));
    return ET_OK;
}

static et_status publish(const char *directory, et_message *message)
{
    char path[PATH];
    const int lock = lock_directory(directory, path);
    et_status status;

    if (lock < 0)
        return cli_stopped() ? cli_check(message) : et_status_fail(message, ET_EIO, "cannot lock %s: %s", path, strerror(errno));
    status = move_all(directory, message);
    unlink(path);
    close(lock);
    return status;
}

/* How far the single precision of STL may move a vertex, as a share of the mesh's longest side: half an ulp of a float, 2^-24, of the
 * greatest coordinate. */
static double stl_rounding(const et_tessellation *mesh)
{
    et_vec3 lo = mesh->vertices[0], hi = lo;
    double most = 0, side;

    for (size_t k = 0; k < mesh->nvertices; k++) {
        const et_vec3 v = mesh->vertices[k];
        lo.x = fmin(lo.x, v.x), lo.y = fmin(lo.y, v.y), lo.z = fmin(lo.z, v.z);
        hi.x = fmax(hi.x, v.x), hi.y = fmax(hi.y, v.y), hi.z = fmax(hi.z, v.z);
        most = fmax(most, fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z))));
    }
    side = fmax(hi.x - lo.x, fmax(hi.y - lo.y, hi.z - lo.z));
    return side > 0 ? 0x1p-24 * most / side : 0;
}

static et_status write_mesh(cli_reconstruction *r, const reconstruct_options *o, et_message *message)
{
    const et_surface_file *final = cli_final(r);
    char path[PATH];
    et_tessellation mesh;
    const size_t nu = o->mesh[0] ? o->mesh[0] : 4 * (r->net.net.nx - 1) + 1, nv = o->mesh[0] ? o->mesh[1] : 4 * (r->net.net.ny - 1) + 1;
    et_status status = et_tessellation_of(&mesh, &final->fit.shell, &final->frame, nu, nv);

    if (status != ET_OK)
        return et_status_fail(message, status, "--mesh %zux%zu cannot be made: %s", nu, nv, et_status_text(status));
    r->vertices = mesh.nvertices;
    r->triangles = mesh.ntriangles;
    r->volume = et_tessellation_volume(&mesh);
    r->stl_rounding = stl_rounding(&mesh);
    status = et_tessellation_write_obj(in(path, stage, "surface.obj"), &mesh, message);
    if (status == ET_OK)
        status = et_tessellation_write_stl(in(path, stage, "surface.stl"), &mesh, message);
    if (status == ET_EINVAL)              /* the only thing a made mesh can be refused for */
        status = et_status_fail(message, ET_EFORMAT, "surface.stl: the coordinates do not fit the single precision of STL");
    et_tessellation_free(&mesh);
    return status;
}

static et_status write_data(cli_reconstruction *r, const et_cloud *cloud, const char *d, const reconstruct_options *o, et_message *message)
{
    const et_surface_file *final = cli_final(r);
    char path[PATH];
    et_status status = et_cloud_write(in(path, d, "cloud.ply"), cloud->points, cloud->count, ET_CLOUD_PLY_LITTLE, message);

    if (status == ET_OK)
        status = et_json_write_net(in(path, d, "net.json"), &r->net, message);
    if (status == ET_OK)
        status = et_json_write_surface(in(path, d, "fit.json"), &r->fit[r->approach], message);
    if (status == ET_OK)
        status = et_json_write_surface(in(path, d, "surface.json"), final, message);
    if (status == ET_OK)
        status = et_iges_write(in(path, d, "surface.igs"), &final->fit.shell, &final->frame, message);
    if (status == ET_OK)
        status = write_mesh(r, o, message);
    if (status == ET_OK)
        status = cli_write_history(in(path, d, "history.csv"), r->refined, r->nrefined, message);
    if (status == ET_OK) {
        json_t *summary = cli_json_summary(r);
        status = cli_write_json(in(path, d, "summary.json"), summary, message);
        json_decref(summary);
    }
    return status == ET_OK ? cli_write_report(in(path, d, "report.md"), r, message) : status;
}

/* ---- pictures, in the cloud's own coordinates ------------------------------------------------------------------------- */

static et_status draw_net(const cli_reconstruction *r, const char *path, et_message *message)
{
    const size_t nov = et_doublenet_nov(r->net.net);
    et_vec3 *points = et_size_array(nov, sizeof *points);
    et_status status;

    if (!points)
        return et_status_fail(message, ET_ENOMEM, "not enough memory");
    memcpy(points, r->net.weights, nov * sizeof *points);
    et_frame_from_unit(points, nov, &r->net.frame);
    status = et_plot_net(path, points, r->net.net, "The double net after training", message);
    free(points);
    return status;
}

static et_status draw_shell(const cli_reconstruction *r, const char *path, et_message *message)
{
    const et_surface_file *final = cli_final(r);
    et_shell own;
    et_status status = et_shell_copy(&own, &final->fit.shell);

    if (status != ET_OK)
        return et_status_fail(message, status, "not enough memory");
    for (size_t w = 0; w < 2; w++)
        et_frame_from_unit(own.view[w].points, own.view[w].nu * own.view[w].nv, &final->frame);
    status = et_plot_shell(path, &own, "Both surfaces and the seam", message);
    et_shell_free(&own);
    return status;
}

static et_status draw_error(const cli_reconstruction *r, const char *path, et_message *message)
{
    const et_surface_file *final = cli_final(r);
    const size_t nov = et_doublenet_nov(r->net.net);
    double *residual = et_size_array(nov, sizeof *residual);
    et_fit_error error;
    et_status status = residual ? cli_residual(residual, &error, final, r->net.weights) : ET_ENOMEM;

    if (status != ET_OK)
        et_status_fail(message, status, "the error cannot be measured: %s", et_status_text(status));
    else
        status = et_plot_error(path, residual, r->net.net, "Distance of net and surface (unit cube)", message);
    free(residual);
    return status;
}

static et_status draw_history(const cli_reconstruction *r, const char *path, et_message *message)
{
    et_plot_curve curves[CLI_ALGORITHMS];

    for (size_t k = 0; k < r->nrefined; k++) {
        const et_plot_curve curve = { cli_algorithm_name(r->refined[k].algorithm), r->refined[k].history, r->refined[k].steps, r->refined[k].before };
        curves[k] = curve;
    }
    return et_plot_history(path, curves, r->nrefined, "Best value after each step", message);
}

static et_status draw(const cli_reconstruction *r, const et_cloud *cloud, const char *d, et_message *message)
{
    char path[PATH];
    et_status status = et_plot_cloud(in(path, d, "cloud.png"), cloud->points, cloud->count, "The cloud", message);

    if (status == ET_OK)
        status = draw_net(r, in(path, d, "net.png"), message);
    if (status == ET_OK)
        status = draw_shell(r, in(path, d, "surface.png"), message);
    if (status == ET_OK)
        status = draw_error(r, in(path, d, "error.png"), message);
    if (status == ET_OK && r->nrefined)
        status = draw_history(r, in(path, d, "convergence.png"), message);
    return status != ET_OK && cli_stopped() ? et_status_fail(message, ET_ESTOPPED, "interrupted; nothing was written") : status;
}

static et_status write_all(cli_reconstruction *r, const et_cloud *cloud, const reconstruct_options *o, et_message *message)
{
    int made = 0;
    et_status status = make_directory(&made, o->directory, message);

    if (status != ET_OK)
        return status;
    status = open_stage(o->directory, message);
    if (status == ET_OK) {
        status = write_data(r, cloud, stage, o, message);
        if (status == ET_OK && r->pictures)
            status = draw(r, cloud, stage, message);
        if (status == ET_OK)
            status = cli_check(message);
        if (status == ET_OK)
            status = publish(o->directory, message);
        cli_on_end(NULL);
        drop_stage();
    }
    if (status != ET_OK && made)
        rmdir(o->directory);
    return status;
}

/* ---- the command ------------------------------------------------------------------------------------------------------ */

static void release(cli_reconstruction *r)
{
    et_json_free_net(&r->net);
    for (size_t a = 0; a < 3; a++)
        et_json_free_surface(&r->fit[a]);
    for (size_t k = 0; k < r->nrefined; k++)
        cli_refined_free(&r->refined[k]);
    free(r->refined);
}

static et_status run_it(const char *path, const reconstruct_options *o, cli_run *run, et_message *message)
{
    cli_reconstruction r;
    et_cloud cloud;
    et_status status = et_cloud_read(&cloud, path, message);

    if (status != ET_OK)
        return status;
    memset(&r, 0, sizeof r);
    r.cloud = path;
    run->input = path;
    r.points = cloud.count;
    r.seed = run->seed;
    r.approach = (size_t)o->fit.approach;
    r.pictures = !o->no_pictures;
    cli_say(run, "%zu points from %s", cloud.count, path);
    status = cli_check(message);
    if (status == ET_OK)
        status = compute(&r, &cloud, o, run, message);
    if (status == ET_OK)
        status = write_all(&r, &cloud, o, message);
    if (status == ET_OK && run->json) {
        json_t *summary = cli_json_summary(&r);
        status = cli_print(summary, message);
        json_decref(summary);
    }
    if (status == ET_OK && r.stl_rounding > 1e-4 && !run->quiet)
        fprintf(stderr, "etalon reconstruct: warning: the single precision of STL moves vertices by up to %.2g of the mesh's size, so far from the\n"
                        "origin is this cloud; use surface.obj or surface.igs\n", r.stl_rounding);
    if (status == ET_OK && !run->json) {
        cli_say(run, "closed surface%s in %s; start with %s/report.md", r.pictures ? ", CAD files and pictures" : " and CAD files", o->directory,
                o->directory);
    }
    release(&r);
    et_cloud_free(&cloud);
    return status;
}

static et_status settle(reconstruct_options *o, int exact, et_message *message)
{
    et_status status = ET_OK;

    if (!o->directory)
        return et_status_fail(message, ET_EINVAL, "--output names the folder to write to: it is needed");
    if (strcmp(o->refine, "none") != 0)
        status = cli_list(o->algorithms, &o->nalgorithms, CLI_ALGORITHMS, o->refine, cli_algorithm_name, "refine", message);
    if (status != ET_OK)
        return status;
    if (o->nalgorithms && o->fit.approach == ET_FIT_CONVENTIONAL)
        return et_status_fail(message, ET_EINVAL, "the conventional approach leaves a gap and cannot be refined: add --refine none");
    for (size_t k = 0; k < o->nalgorithms; k++)
        if (exact && o->algorithms[k] == CLI_CERES_FULL)
            return et_status_fail(message, ET_EINVAL, "--exact measures at the fit's parameters, ceres-full has its own");
    o->refiner.exact = exact;
    if (o->refiner.faithful)
        o->fit.knots = ET_KNOTRULE_FAITHFUL;
    if (o->mesh[0] == 1 || o->mesh[1] == 1 || !o->mesh[0] != !o->mesh[1])
        return et_status_fail(message, ET_EINVAL, "--mesh wants at least 2x2");
    return cli_refine_settle(&o->refiner, message);
}

et_status cli_reconstruct(int argc, char **argv, et_message *message)
{
    reconstruct_options o;
    cli_run run = cli_run_defaults();
    const char *positional[1];
    int frame = ET_FRAME_BOX;
    size_t n;
    const cli_help help = { "reconstruct", "etalon reconstruct CLOUD -o DIR [options]",
                            "Turn a point cloud into a closed, gap-free, refined NURBS surface: net, surface, IGES, OBJ, STL, pictures, report.",
                            "  etalon reconstruct scan.xyz -o out\n"
                            "  etalon reconstruct s.xyz --grid 20x20 --control 12x12 --method chord --approach improved --refine de --seed 1 -o out\n"
                            "  etalon reconstruct s.xyz --approach joint --refine ga,de,pso,ceres,ceres-full -o out\n", 1, 1 };

    memset(&o, 0, sizeof o);
    o.refine = "ceres";
    o.train = cli_train_defaults();
    o.fit = cli_fit_choice_defaults();
    o.refiner = cli_refine_defaults();
    cli_option options[TABLE] = {
        { "output", 'o', CLI_TEXT, &o.directory, "DIR", "the folder to write to (needed)", NULL },
        { "approach", 0, CLI_NAME, &o.fit.approach, "WORD", "how the views are joined (default improved)", cli_approach_name },
        { "refine", 0, CLI_TEXT, &o.refine, "LIST", "ga, de, pso, ceres, ceres-full, optimum, joined by commas, or none; the best is taken (default ceres)", NULL },
        { "mesh", 0, CLI_PAIR, &o.mesh, "AxB", "points a view of the OBJ and STL mesh (default: 4 to a cell of the grid)", NULL },
        { "exact", 0, CLI_FLAG, &run.exact, NULL, "fits, errors and the net's quality correctly rounded", NULL },
        { "no-pictures", 0, CLI_FLAG, &o.no_pictures, NULL, "draw nothing (gnuplot is not needed then)", NULL },
    };
    cli_train_table(options + OWN, &o.train, &frame);
    cli_fit_table(options + OWN + CLI_TRAIN_OPTIONS, &o.fit);
    cli_refine_table(options + OWN + CLI_TRAIN_OPTIONS + CLI_FIT_OPTIONS, &o.refiner);
    cli_common(options + TABLE - CLI_COMMON, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, TABLE, &help, message);
    if (status != ET_OK || run.help)
        return status;
    o.train.frame = (et_frame_kind)frame;
    status = settle(&o, run.exact, message);
    return status == ET_OK ? run_it(positional[0], &o, &run, message) : status;
}
