/* report: summary.json and report.md of a reconstruction (docs/files.md). */
#include "cli/cli.h"
#include "etalon/io/file.h"

const et_surface_file *cli_final(const cli_reconstruction *r)
{
    return r->best < r->nrefined ? &r->refined[r->best].surface : &r->fit[r->approach];
}

static json_t *vec3(et_vec3 v)
{
    return json_pack("[f, f, f]", v.x, v.y, v.z);
}

json_t *cli_json_summary(const cli_reconstruction *r)
{
    const et_surface_file *final = cli_final(r);
    json_t *fit = cli_json_fit(&r->fit[r->approach], r->overshoot), *refine = json_array(), *object;

    if (fit) {
        cli_json_add(&fit, "surface_error_conventional", json_real(r->fit[ET_FIT_CONVENTIONAL].error.nov));
        cli_json_add(&fit, "surface_error_conventional_non", json_real(r->fit[ET_FIT_CONVENTIONAL].error.non));
        cli_json_add(&fit, "surface_error_improved", json_real(r->fit[ET_FIT_IMPROVED].error.nov));
        cli_json_add(&fit, "surface_error_joint", json_real(r->fit[ET_FIT_JOINT].error.nov));
        cli_json_add(&fit, "seam_gap_conventional", json_real(r->fit[ET_FIT_CONVENTIONAL].seam_gap));
        cli_json_add(&fit, "seconds", json_real(r->fit_seconds));
    }
    for (size_t k = 0; k < r->nrefined; k++)
        cli_json_append(&refine, cli_json_refined(&r->refined[k]));
    object = json_pack("{s:s, s:i, s:{s:o, s:I}, s:o, s:{s:o, s:o}, s:o, s:o, s:o, s:{s:s, s:f, s:f, s:b}, s:{s:I, s:I, s:f, s:f}}", "format",
                       "etalon-summary", "version", 1, "cloud", "file", cli_json_text(r->cloud), "points", (json_int_t)r->points, "seed",
                       json_sprintf("%llu", (unsigned long long)r->seed), "frame", "offset", vec3(r->net.frame.offset), "scale",
                       vec3(r->net.frame.scale), "som", cli_json_som(&r->net, r->train_seconds), "fit", fit, "refine", refine, "surface", "from",
                       r->best < r->nrefined ? cli_algorithm_name(r->refined[r->best].algorithm) : "fit", "error", final->error.nov, "seam_gap",
                       final->seam_gap, "closed", et_shell_closed(&final->fit.shell), "mesh", "vertices", (json_int_t)r->vertices, "triangles",
                       (json_int_t)r->triangles, "volume", r->volume, "stl_rounding", r->stl_rounding);
    return object;
}

static void tell_net(FILE *f, const cli_reconstruction *r)
{
    const et_net_file *n = &r->net;

    fprintf(f, "# Reconstruction of %s\n\n%zu points, seed %llu. Lengths in the sections on the net and the fit are in the unit cube to which the cloud was\n"
               "mapped; the CAD files and the mesh are in the cloud's own coordinates.\n\n", r->cloud, r->points, (unsigned long long)r->seed);
    if (r->pictures)
        fprintf(f, "![The cloud](cloud.png)\n\n");
    /* In pieces: for many conversions at once the C library takes memory and, without it, ends in the middle and marks no error. */
    fprintf(f, "## The net\n\nA double net of %zu x %zu: NON %zu nodes, NOV %zu classes, NOR %zu redundant. ", n->net.nx, n->net.ny,
            et_doublenet_non(n->net), et_doublenet_nov(n->net), et_doublenet_nor(n->net));
    fprintf(f, "%zu steps, %.2f s CPU.\n\n| | QE | TE | least error | greatest error |\n|---|---|---|---|---|\n", n->training.steps, r->train_seconds);
    fprintf(f, "| while training | %.6f | %.6f | %.6f | %.6f |\n", n->training.qe, n->training.te, n->training.min_error, n->training.max_error);
    fprintf(f, "| after training, all points | %.6f | %.6f | %.6f | %.6f |\n\n", n->final.qe, n->final.te, n->final.min_error, n->final.max_error);
    if (r->pictures)
        fprintf(f, "![The two views of the net](net.png)\n\n");
}

static void tell_fit(FILE *f, const cli_reconstruction *r)
{
    const et_fit_options *o = &r->fit[r->approach].options;

    fprintf(f, "## The fit\n\nControl net %zu x %zu, degree %zu x %zu, %s parameters, %s knots, %s.\n\n"
               "| approach | error over NOV | error over NON | greatest | seam gap | corner error |\n|---|---|---|---|---|---|\n",
            o->control.nx, o->control.ny, o->p, o->q, et_param_name(o->method), et_knotrule_name(o->knots), et_linalg_name(o->algebra));
    for (size_t a = 0; a < 3; a++)
        fprintf(f, "| %s%s | %.6f | %.6f | %.6f | %.3g | %.3g |\n", et_fit_name((et_fit_approach)a), a == r->approach ? " (taken)" : "",
                r->fit[a].error.nov, r->fit[a].error.non, r->fit[a].error.greatest, r->fit[a].seam_gap, r->fit[a].error.corner);
    if (r->overshoot > 1)
        fprintf(f, "\n**Control points leave the box of the net by %.3g times its size: the surface swings out between the data.** Take fewer control points.\n",
                r->overshoot);
    fprintf(f, "\nThe conventional approach counts each border point once here (NOV) and twice in the NON column; the source compares its NON with the\n"
               "NOV of the improved one.\n\n");
}

static void tell_refinement(FILE *f, const cli_reconstruction *r)
{
    const et_surface_file *final = cli_final(r);

    if (r->nrefined)
        fprintf(f, "## The refinement\n\n| algorithm | before | after | gained | evaluations | steps | CPU s |\n|---|---|---|---|---|---|---|\n");
    for (size_t k = 0; k < r->nrefined; k++)
        fprintf(f, "| %s%s | %.9f | %.9f | %.3g %% | %llu | %zu | %.2f |\n", cli_algorithm_name(r->refined[k].algorithm),
                k == r->best ? " (taken)" : "", r->refined[k].before, r->refined[k].after,
                r->refined[k].before > 0 ? 100 * (1 - r->refined[k].after / r->refined[k].before) : 0.0,
                (unsigned long long)r->refined[k].evaluations, r->refined[k].steps, r->refined[k].seconds);
    for (size_t k = 0; k < r->nrefined; k++)
        if (r->refined[k].algorithm == CLI_OPTIMUM)
            fprintf(f, "\nCertified: no closed surface with these knots and parameters has an error below %.12g; the optimum found is at most %.3g above that.\n",
                    r->refined[k].optimum.lower, r->refined[k].optimum.gap);
    if (r->nrefined && r->pictures)
        fprintf(f, "\n![Convergence](convergence.png)\n");
    fprintf(f, "\n## The surface\n\nError %.9f over NOV, seam gap %.3g, corner error %.3g.\n\n", final->error.nov, final->seam_gap, final->error.corner);
    if (r->pictures)
        fprintf(f, "![Both surfaces and the seam](surface.png)\n\n![Error over the surface](error.png)\n\n");
    fprintf(f, "The mesh (`surface.obj`, `surface.stl`) has %zu vertices and %zu triangles and encloses a volume of %.9g.\n\n", r->vertices, r->triangles,
            r->volume);
    fprintf(f, "Files: `cloud.ply`, `net.json`, `fit.json` (before refinement), `surface.json`, `surface.igs` (for CAD), `surface.obj`, `surface.stl`,\n"
               "`history.csv`, `summary.json`.\n");
}

et_status cli_write_report(const char *path, const cli_reconstruction *r, et_message *message)
{
    et_file file;
    const et_status status = et_file_create(&file, path, message);

    if (status != ET_OK)
        return status;
    tell_net(file.stream, r);
    tell_fit(file.stream, r);
    tell_refinement(file.stream, r);
    return et_file_commit(&file, message);
}
