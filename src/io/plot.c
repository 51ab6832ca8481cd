#include "etalon/io/plot.h"
#include "etalon/base/rng.h"
#include "etalon/base/size.h"
#include "etalon/io/file.h"
#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum { WIRES = 21, STEPS = 121, MOST_STEPS = 4000 };

static const char BOTTOM_COLOUR[] = "#2166ac", TOP_COLOUR[] = "#e08214", SEAM_COLOUR[] = "#b2182b";

/* ---- running gnuplot ---- */

/* What gnuplot wrote to its standard error, its first line that says something. */
static void complaint(char *text, size_t size, FILE *errors)
{
    char line[256];

    snprintf(text, size, "no reason given");
    rewind(errors);
    while (fgets(line, sizeof line, errors)) {
        line[strcspn(line, "\r\n")] = '\0';
        if (strspn(line, " \t^") < strlen(line) && !strstr(line, "gnuplot>")) {
            snprintf(text, size, "%s", line);
            if (strstr(line, "line "))
                return;
        }
    }
}

/* Room or memory: errno tells which is short. */
static et_status no_temporary(et_message *message)
{
    return errno == ENOMEM ? et_status_fail(message, ET_ENOMEM, "out of memory")
                           : et_status_fail(message, ET_EIO, "cannot write a temporary file for gnuplot");
}

static et_status spawn(pid_t *child, FILE *script, FILE *errors, FILE *picture)
{
    char name[] = "gnuplot";
    char *argument[] = {name, NULL};
    posix_spawn_file_actions_t actions;
    int failed;

    if (posix_spawn_file_actions_init(&actions))
        return ET_ENOMEM;
    failed = posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
    failed = failed ? failed : posix_spawn_file_actions_adddup2(&actions, fileno(picture), STDOUT_FILENO);
    failed = failed ? failed : posix_spawn_file_actions_adddup2(&actions, fileno(errors), STDERR_FILENO);
    failed = failed ? failed : posix_spawnp(child, name, &actions, NULL, argument, environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed == ENOMEM ? ET_ENOMEM : failed ? ET_EIO : ET_OK;
}

/* Run the script, its output into the picture. */
static et_status run(FILE *script, FILE *picture, et_message *message)
{
    FILE *const errors = tmpfile();
    char reason[256];
    pid_t child = 0;
    int ended = -1;
    et_status status = ET_EIO, started;

    if (!errors || fflush(script) || ferror(script) || fseek(script, 0, SEEK_SET)) {
        status = no_temporary(message);
    } else if ((started = spawn(&child, script, errors, picture)) == ET_ENOMEM) {
        status = et_status_fail(message, ET_ENOMEM, "out of memory");
    } else if (started || waitpid(child, &ended, 0) != child || (WIFEXITED(ended) && WEXITSTATUS(ended) == 127)) {
        et_status_fail(message, ET_EIO, "gnuplot cannot be run: pictures need it in the PATH");
    } else if (!WIFEXITED(ended) || WEXITSTATUS(ended)) {
        complaint(reason, sizeof reason, errors);
        et_status_fail(message, ET_EIO, "gnuplot failed: %s", reason);
    } else {
        status = ET_OK;
    }
    if (errors)
        fclose(errors);
    return status;
}

/* A picture being made: the script is written by the caller, then finish() runs it. */
typedef struct {
    et_file file;
    FILE *script;
} canvas;

static et_status begin(canvas *c, const char *path, int width, int height, et_message *message)
{
    et_status status;

    c->script = tmpfile();
    if (!c->script)
        return no_temporary(message);
    status = et_file_create(&c->file, path, message);
    if (status) {
        fclose(c->script);
        return status;
    }
    fprintf(c->script,
            "set encoding utf8\n"
            "set terminal pngcairo size %d,%d font 'Sans,12' noenhanced background '#ffffff'\n"
            "set border lc rgb '#444444'\n"
            "set xyplane relative 0.06\n",
            width, height);
    return ET_OK;
}

static et_status finish(canvas *c, et_message *message)
{
    et_status status;

    fflush(c->file.stream);
    status = run(c->script, c->file.stream, message);
    fclose(c->script);
    if (status) {
        et_file_abandon(&c->file);
        return status;
    }
    return et_file_commit(&c->file, message);
}

/* "text" with everything gnuplot might obey (quotes, backslash, backquote, @) in octal, and blanks for what would end the line. */
static void put_text(FILE *script, const char *text)
{
    fputc('"', script);
    for (const char *t = text ? text : ""; *t; t++) {
        const unsigned char c = (unsigned char)*t;

        if (strchr("\"'\\`@$", c))
            fprintf(script, "\\%03o", c);
        else
            fputc(c < ' ' || c == 0x7f ? ' ' : c, script);
    }
    fputc('"', script);
}

static void put_title(FILE *script, const char *command, const char *title)
{
    fprintf(script, "%s ", command);
    put_text(script, title);
    fputs(" noenhanced font 'Sans,15'\n", script);
}

static void put_point(FILE *script, et_vec3 p)
{
    fprintf(script, "%.9g %.9g %.9g\n", p.x, p.y, p.z);
}

/* The extents of a box, largest first. */
static void extents(double side[3], const et_vec3 *points, size_t n)
{
    et_vec3 lo = points[0], hi = lo;

    for (size_t k = 1; k < n; k++) {
        lo.x = fmin(lo.x, points[k].x), lo.y = fmin(lo.y, points[k].y), lo.z = fmin(lo.z, points[k].z);
        hi.x = fmax(hi.x, points[k].x), hi.y = fmax(hi.y, points[k].y), hi.z = fmax(hi.z, points[k].z);
    }
    side[0] = hi.x - lo.x, side[1] = hi.y - lo.y, side[2] = hi.z - lo.z;
    for (size_t a = 0; a < 2; a++)
        for (size_t b = a + 1; b < 3; b++)
            if (side[b] > side[a]) {
                const double t = side[a];
                side[a] = side[b];
                side[b] = t;
            }
}

/* 1, 2 or 5 times a power of ten: about a fifth of side. */
static double tic_step(double side)
{
    double step = 1;

    while (step > side / 5)
        step /= 10;
    while (step * 10 <= side / 5)
        step *= 10;
    return step * 5 <= side / 5 ? 5 * step : step * 2 <= side / 5 ? 2 * step : step;
}

/* One scale and one step for all axes, so that a long thin body is drawn as one; its picture is enlarged instead. */
static void set_space(FILE *script, const et_vec3 *points, size_t n)
{
    double side[3];

    extents(side, points, n);
    fprintf(script,
            "set view equal xyz\n"
            "set view 62,38,%s\n"
            "set xlabel 'x'\nset ylabel 'y'\nset zlabel 'z'\n"
            "set ticslevel 0.06\n"
            "set grid x y lt 1 lc rgb '#cccccc'\n",
            side[1] < 0.4 * side[0] ? "1.6" : "1");
    for (size_t axis = 0; axis < 3; axis++)
        if (side[0] > 1e-300 && side[0] < 1e300)
            fprintf(script, "set %ctics nomirror %.3g\n", "xyz"[axis], tic_step(side[0]));
        else
            fprintf(script, "set %ctics nomirror\n", "xyz"[axis]);
    fputs("set xtics offset -0.8,-0.4\nset ytics offset 0.8,-0.2\nset format '%.8g'\n", script);
}

/* ---- cloud ---- */

static int is_drawn(size_t i, size_t n)
{
    return n <= ET_PLOT_MOST || (double)(et_rng_stream(1, i) >> 11) * 0x1p-53 * (double)n < (double)ET_PLOT_MOST;
}

et_status et_plot_cloud(const char *path, const et_vec3 *points, size_t n, const char *title, et_message *message)
{
    canvas c;
    et_status status;

    if (!path || !points || n == 0 || !et_vec3_finite(points, n))
        return et_status_fail(message, ET_EINVAL, "plot: no path, no points, or points that are not finite");
    status = begin(&c, path, 1200, 900, message);
    if (status)
        return status;
    fputs("$cloud << EOD\n", c.script);
    for (size_t i = 0; i < n; i++)
        if (is_drawn(i, n))
            put_point(c.script, points[i]);
    fputs("EOD\n", c.script);
    set_space(c.script, points, n);
    put_title(c.script, "set title", title);
    fputs("set palette defined (0 '#2166ac', 0.5 '#7fbf7b', 1 '#e08214')\nunset colorbox\nunset key\n", c.script);
    fprintf(c.script, "splot $cloud using 1:2:3:3 with points pt 7 ps %s lc palette\n", n > 5000 ? "0.35" : n > 500 ? "0.6" : "1.2");
    return finish(&c, message);
}

/* ---- wire frames ---- */

/* Every class of the seam, closed. */
static void put_seam(FILE *script, const et_vec3 *weights, et_doublenet net)
{
    fputs("$seam << EOD\n", script);
    for (size_t j = 0; j < net.ny; j++)
        put_point(script, weights[j]);
    for (size_t i = 1; i < net.nx; i++)
        put_point(script, weights[i * net.ny + net.ny - 1]);
    for (size_t j = net.ny - 1; j-- > 0;)
        put_point(script, weights[(net.nx - 1) * net.ny + j]);
    for (size_t i = net.nx - 1; i-- > 0;)
        put_point(script, weights[i * net.ny]);
    fputs("EOD\n", script);
}

static void put_view(FILE *script, const et_vec3 *weights, et_doublenet net, size_t view)
{
    fprintf(script, "$view%zu << EOD\n", view);
    for (size_t i = 0; i < net.nx; i++) {
        for (size_t j = 0; j < net.ny; j++)
            put_point(script, weights[et_doublenet_class(net, view, i, j) - 1]);
        fputs("\n\n", script);
    }
    for (size_t j = 0; j < net.ny; j++) {
        for (size_t i = 0; i < net.nx; i++)
            put_point(script, weights[et_doublenet_class(net, view, i, j) - 1]);
        fputs("\n\n", script);
    }
    fputs("EOD\n", script);
}

/* Axes common to both views, so that they can be compared. */
static void set_ranges(FILE *script, const et_vec3 *p, size_t n)
{
    static const char axis[] = "xyz";

    for (size_t k = 0; k < 3; k++) {
        double lo = (&p[0].x)[k], hi = lo, margin;

        for (size_t i = 1; i < n; i++) {
            lo = fmin(lo, (&p[i].x)[k]);
            hi = fmax(hi, (&p[i].x)[k]);
        }
        margin = hi > lo ? 0.03 * (hi - lo) : 0.5 * fmax(fabs(hi), 1e-3);
        fprintf(script, "set %crange [%.9g:%.9g]\n", axis[k], lo - margin, hi + margin);
    }
}

et_status et_plot_net(const char *path, const et_vec3 *weights, et_doublenet net, const char *title, et_message *message)
{
    canvas c;
    et_status status;

    if (!path || !weights || !et_doublenet_valid(net) || !et_vec3_finite(weights, et_doublenet_nov(net)))
        return et_status_fail(message, ET_EINVAL, "plot: no path, no net, or weights that are not finite");
    status = begin(&c, path, 1600, 800, message);
    if (status)
        return status;
    put_seam(c.script, weights, net);
    put_view(c.script, weights, net, ET_BOTTOM);
    put_view(c.script, weights, net, ET_TOP);
    set_space(c.script, weights, et_doublenet_nov(net));
    set_ranges(c.script, weights, et_doublenet_nov(net));
    put_title(c.script, "set multiplot layout 1,2 title", title);
    fputs("set key top right\n", c.script);
    for (size_t view = ET_BOTTOM; view <= ET_TOP; view++)
        fprintf(c.script,
                "splot $view%zu using 1:2:3 with lines lw 1.2 lc rgb '%s' title '%s view', "
                "$view%zu using 1:2:3 with points pt 7 ps 0.4 lc rgb '%s' notitle, $seam using 1:2:3 with lines lw 4 lc rgb '%s' title 'seam'\n",
                view, view ? TOP_COLOUR : BOTTOM_COLOUR, view ? "top" : "bottom", view, view ? TOP_COLOUR : BOTTOM_COLOUR, SEAM_COLOUR);
    fputs("unset multiplot\n", c.script);
    return finish(&c, message);
}

/* ---- shell ---- */

/* Lines of constant u (or v): WIRES of them, STEPS points each. */
static et_status put_wires(FILE *script, const et_surface *s, size_t view)
{
    double few[WIRES], many[STEPS];
    et_vec3 *const p = et_size_array((size_t)WIRES * STEPS, sizeof *p);
    et_status status = p ? ET_OK : ET_ENOMEM;

    for (size_t k = 0; k < WIRES; k++)
        few[k] = (double)k / (WIRES - 1);
    for (size_t k = 0; k < STEPS; k++)
        many[k] = (double)k / (STEPS - 1);
    fprintf(script, "$view%zu << EOD\n", view);
    for (int along_v = 1; !status && along_v >= 0; along_v--) {
        status = along_v ? et_surface_grid(p, s, few, WIRES, many, STEPS) : et_surface_grid(p, s, many, STEPS, few, WIRES);
        for (size_t line = 0; !status && line < WIRES; line++) {
            for (size_t k = 0; k < STEPS; k++)
                put_point(script, along_v ? p[line * STEPS + k] : p[k * WIRES + line]);
            fputs("\n\n", script);
        }
    }
    fputs("EOD\n", script);
    free(p);
    return status;
}

static et_status put_border(FILE *script, const et_surface *s)
{
    const double end[2] = {0, 1};
    double many[STEPS];
    et_vec3 side[2 * STEPS];
    et_status status = ET_OK;

    for (size_t k = 0; k < STEPS; k++)
        many[k] = (double)k / (STEPS - 1);
    fputs("$seam << EOD\n", script);
    for (int along_v = 1; !status && along_v >= 0; along_v--) {
        status = along_v ? et_surface_grid(side, s, end, 2, many, STEPS) : et_surface_grid(side, s, many, STEPS, end, 2);
        for (size_t line = 0; !status && line < 2; line++) {
            for (size_t k = 0; k < STEPS; k++)
                put_point(script, along_v ? side[line * STEPS + k] : side[2 * k + line]);
            fputs("\n\n", script);
        }
    }
    fputs("EOD\n", script);
    return status;
}

et_status et_plot_shell(const char *path, const et_shell *shell, const char *title, et_message *message)
{
    canvas c;
    et_status status;

    if (!path || !shell || !et_shell_valid(shell))
        return et_status_fail(message, ET_EINVAL, "plot: no path, or not a valid shell");
    status = begin(&c, path, 1200, 900, message);
    if (status)
        return status;
    status = put_wires(c.script, &shell->view[ET_BOTTOM], ET_BOTTOM);
    if (!status)
        status = put_wires(c.script, &shell->view[ET_TOP], ET_TOP);
    if (!status)
        status = put_border(c.script, &shell->view[ET_BOTTOM]);
    if (status) {
        fclose(c.script);
        et_file_abandon(&c.file);
        return et_status_fail(message, status, "plot: %s", et_status_text(status));
    }
    set_space(c.script, shell->view[ET_BOTTOM].points, shell->view[ET_BOTTOM].nu * shell->view[ET_BOTTOM].nv);
    put_title(c.script, "set title", title);
    fprintf(c.script,
            "set key top right\n"
            "splot $view0 using 1:2:3 with lines lw 1 lc rgb '%s' title 'bottom', $view1 using 1:2:3 with lines lw 1 lc rgb '%s' title 'top', "
            "$seam using 1:2:3 with lines lw 5 lc rgb '%s' title 'seam'\n",
            BOTTOM_COLOUR, TOP_COLOUR, SEAM_COLOUR);
    return finish(&c, message);
}

/* ---- residuals ---- */

static void put_map(FILE *script, const double *residual, et_doublenet net, size_t view)
{
    fprintf(script, "$view%zu << EOD\n", view);
    for (size_t j = 0; j < net.ny; j++) {
        for (size_t i = 0; i < net.nx; i++)
            fprintf(script, "%zu %zu %.9g\n", i, j, residual[et_doublenet_class(net, view, i, j) - 1]);
        fputs("\n", script);
    }
    fputs("EOD\n", script);
}

static int residuals_valid(double *greatest, const double *residual, size_t n)
{
    *greatest = 0;
    for (size_t k = 0; k < n; k++) {
        if (!(residual[k] >= 0 && residual[k] <= 1e300))
            return 0;
        *greatest = fmax(*greatest, residual[k]);
    }
    return 1;
}

et_status et_plot_error(const char *path, const double *residual, et_doublenet net, const char *title, et_message *message)
{
    double greatest;
    canvas c;
    et_status status;

    if (!path || !residual || !et_doublenet_valid(net) || !residuals_valid(&greatest, residual, et_doublenet_nov(net)))
        return et_status_fail(message, ET_EINVAL, "plot: no path, no net, or residuals that are no distances");
    status = begin(&c, path, 1600, 800, message);
    if (status)
        return status;
    put_map(c.script, residual, net, ET_BOTTOM);
    put_map(c.script, residual, net, ET_TOP);
    fprintf(c.script, "set cbrange [0:%.9g]\n", greatest > 0 ? greatest : 1);
    fprintf(c.script, "set xrange [-0.5:%zu.5]\nset yrange [-0.5:%zu.5]\n", net.nx - 1, net.ny - 1);
    fputs("set palette defined (0 '#440154', 0.25 '#3b528b', 0.5 '#21918c', 0.75 '#5ec962', 1 '#fde725')\n"
          "set format cb '%.1e'\nset cblabel 'distance' offset 2\nunset key\nset tics out nomirror\nset size ratio -1\n"
          "set xlabel 'i (along u)'\nset ylabel 'j (along v)'\nset rmargin 14\n",
          c.script);
    put_title(c.script, "set multiplot layout 1,2 title", title);
    fputs("set title 'bottom view'\nplot $view0 using 1:2:3 with image\n"
          "set title 'top view'\nplot $view1 using 1:2:3 with image\nunset multiplot\n",
          c.script);
    return finish(&c, message);
}

/* ---- histories ---- */

/* Least and greatest of all that is drawn; 0 if something is not finite or a curve is empty. */
static int curves_range(double *lo, double *hi, const et_plot_curve *curves, size_t n)
{
    *lo = HUGE_VAL;
    *hi = -HUGE_VAL;
    for (size_t c = 0; c < n; c++) {
        if (!curves[c].value || curves[c].count == 0 || isinf(curves[c].before))
            return 0;
        for (size_t k = 0; k < curves[c].count; k++) {
            if (!isfinite(curves[c].value[k]))
                return 0;
            *lo = fmin(*lo, curves[c].value[k]);
            *hi = fmax(*hi, curves[c].value[k]);
        }
        if (!isnan(curves[c].before)) {
            *lo = fmin(*lo, curves[c].before);
            *hi = fmax(*hi, curves[c].before);
        }
    }
    return 1;
}

/* Every step of a short curve; of a long one MOST_STEPS of them, the first and the last among these. */
static void put_curve(FILE *script, const et_plot_curve *curve, size_t number)
{
    const size_t stride = (curve->count - 1) / MOST_STEPS + 1;

    fprintf(script, "$curve%zu << EOD\n", number);
    for (size_t k = 0; k < curve->count; k++)
        if (k % stride == 0 || k + 1 == curve->count)
            fprintf(script, "%zu %.17g\n", k + 1, curve->value[k]);
    fputs("EOD\n", script);
}

static int before_is_new(const et_plot_curve *curves, size_t c)
{
    for (size_t k = 0; k < c; k++)
        if (fabs(curves[k].before - curves[c].before) <= 1e-9 * fabs(curves[c].before))    /* one line to the eye */
            return 0;
    return !isnan(curves[c].before);
}

static void plot_curves(FILE *script, const et_plot_curve *curves, size_t n)
{
    static const char *const colour[] = {"#2166ac", "#e08214", "#1b7837", "#b2182b", "#762a83", "#35978f", "#8c510a", "#666666"};
    const char *separator = "plot ";

    for (size_t c = 0; c < n; c++) {
        fprintf(script, "%s$curve%zu using 1:2 with %s lw 2 pt 7 ps 0.8 lc rgb '%s' title ", separator, c,
                curves[c].count == 1 ? "points" : "lines", colour[c % 8]);
        put_text(script, curves[c].label);
        separator = ", ";
    }
    for (size_t c = 0; c < n; c++)
        if (before_is_new(curves, c))
            fprintf(script, ", %.17g with lines dashtype 2 lw 1.5 lc rgb '#555555' title 'before (%.6g)'", curves[c].before, curves[c].before);
    fputc('\n', script);
}

et_status et_plot_history(const char *path, const et_plot_curve *curves, size_t n, const char *title, et_message *message)
{
    double lo, hi;
    size_t most = 1;
    canvas c;
    et_status status;

    if (!path || !curves || n == 0 || !curves_range(&lo, &hi, curves, n))
        return et_status_fail(message, ET_EINVAL, "plot: no path, no curves, or values that are not finite");
    status = begin(&c, path, 1200, 900, message);
    if (status)
        return status;
    for (size_t k = 0; k < n; k++)
        put_curve(c.script, &curves[k], k);
    put_title(c.script, "set title", title);
    fputs("set xlabel 'step'\nset ylabel 'value'\nset grid lt 1 lc rgb '#cccccc'\nset key outside right top vertical noenhanced\n"
          "set tics nomirror out\nset format y '%.6g'\nset lmargin 16\n",
          c.script);
    for (size_t k = 0; k < n; k++)
        most = curves[k].count > most ? curves[k].count : most;
    fprintf(c.script, "set xrange [0:%zu]\n", most);
    if (lo > 0 && hi > 5 * lo)
        fputs("set logscale y\nset format y '%g'\n", c.script);
    else if (hi > lo)
        fprintf(c.script, "set yrange [%.17g:%.17g]\n", lo - 0.04 * (hi - lo), hi + 0.06 * (hi - lo));
    else
        fprintf(c.script, "set yrange [%.17g:%.17g]\n", lo - 0.05 * fmax(fabs(lo), 1e-9), hi + 0.05 * fmax(fabs(hi), 1e-9));
    plot_curves(c.script, curves, n);
    return finish(&c, message);
}
