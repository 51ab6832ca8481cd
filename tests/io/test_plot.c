#include "etalon/io/plot.h"
#include "some_shell.h"
#include <math.h>

/* gnuplot takes a tenth of a second and more: most cases only try what must be refused, one in RARE draws. */
enum { RARE = 250 };

typedef enum { CLOUD, NET, SHELL, ERRORS, HISTORY } kind;

/* All that the five pictures need. */
typedef struct {
    et_vec3 points[72];
    double residual[72];
    et_doublenet net;
    size_t n;
    et_shell shell;
    et_plot_curve curves[3];
} scene;

static const char *const titles[] = {"", "plain", "it's 100 % \"quoted\" $x `date` @m", "a_b^2 {/Bold c} \\n \\", "line\nend\t\001", "'; exit 1; '", NULL};

static bool some_scene(gen *g, scene *s)
{
    s->net = (et_doublenet){2 + (size_t)gen_upto(g, 4), 2 + (size_t)gen_upto(g, 4)};
    s->n = et_doublenet_nov(s->net);
    gen_points(g, &s->points[0].x, s->n);
    for (size_t k = 0; k < s->n; k++)
        s->residual[k] = gen_real(g, 0, 1);
    s->curves[0] = (et_plot_curve){"falls", s->residual, 1 + (size_t)gen_upto(g, s->n - 1), gen_chance(g, 2) ? 2 : NAN};
    s->curves[1] = (et_plot_curve){"'a' $b _c", s->residual + 1, 1, 2};
    s->curves[2] = (et_plot_curve){NULL, s->residual, 2, 0.5};
    return some_shell(g, &s->shell, 1) == ET_OK;
}

static et_status draw(kind what, const char *path, const scene *s, const char *title, et_message *message)
{
    switch (what) {
    case CLOUD: return et_plot_cloud(path, s->points, s->n, title, message);
    case NET: return et_plot_net(path, s->points, s->net, title, message);
    case SHELL: return et_plot_shell(path, &s->shell, title, message);
    case ERRORS: return et_plot_error(path, s->residual, s->net, title, message);
    default: return et_plot_history(path, s->curves, 3, title, message);
    }
}

static unsigned number_at(const unsigned char *b)
{
    return (unsigned)b[0] << 24 | (unsigned)b[1] << 16 | (unsigned)b[2] << 8 | b[3];
}

/* A whole PNG of the stated size: signature, IHDR, and IEND as the last chunk. */
static bool png_is(gen *g, const char *path, unsigned width, unsigned height)
{
    size_t size;
    char *const text = whole_file(path, &size);
    const unsigned char *const b = (const unsigned char *)text;
    bool ok = gen_check(g, text && size > 100 && memcmp(b, "\211PNG\r\n\032\n", 8) == 0, "no PNG");

    ok = ok && gen_check(g, number_at(b + 16) == width && number_at(b + 20) == height, "%u x %u", number_at(b + 16), number_at(b + 20));
    ok = ok && gen_check(g, memcmp(b + size - 8, "IEND", 4) == 0, "cut short");
    free(text);
    return ok;
}

/* An earlier file of the name, "old", stays when the picture fails; no other file appears. */
static bool stays(gen *g, const char *path)
{
    size_t size;
    char *const text = whole_file(path, &size);
    const bool ok = gen_check(g, text && strcmp(text, "old") == 0, "the earlier file is gone");

    free(text);
    return ok;
}

static bool put_old(const char *path)
{
    FILE *const f = fopen(path, "w");
    const bool ok = f && fputs("old", f) >= 0;

    if (f)
        fclose(f);
    return ok;
}

static bool without_gnuplot(gen *g, kind what, const char *path, const scene *s)
{
    const char *const old = getenv("PATH");
    char *const keep = old ? strdup(old) : NULL;
    et_message message = {""};
    bool ok = put_old(path) && setenv("PATH", "/nonexistent", 1) == 0;

    ok = ok && gen_check(g, draw(what, path, s, "t", &message) == ET_EIO, "drawn without gnuplot");
    ok = ok && gen_check(g, strstr(message.text, "gnuplot") && strstr(message.text, "PATH"), "message: %s", message.text) && stays(g, path);
    if (keep)
        setenv("PATH", keep, 1);
    free(keep);
    return ok;
}

/* A gnuplot that fails tells why. */
static bool with_bad_gnuplot(gen *g, kind what, const char *path, const scene *s)
{
    const char *const old = getenv("PATH");
    char *const keep = old ? strdup(old) : NULL;
    char directory[300], program[400], text[700];
    et_message message = {""};
    FILE *f;
    bool ok;

    snprintf(directory, sizeof directory, "%s.d", path);
    snprintf(program, sizeof program, "%s/gnuplot", directory);
    snprintf(text, sizeof text, "mkdir -p '%s'", directory);
    ok = put_old(path) && system(text) == 0 && (f = fopen(program, "w")) != NULL;
    if (ok) {
        fputs("#!/bin/sh\necho '\"-\" line 7: a made-up reason' >&2\nexit 1\n", f);
        fclose(f);
        snprintf(text, sizeof text, "chmod +x '%s'", program);
        ok = system(text) == 0 && setenv("PATH", directory, 1) == 0;
    }
    ok = ok && gen_check(g, draw(what, path, s, "t", &message) == ET_EIO, "drawn by a gnuplot that fails");
    ok = ok && gen_check(g, strstr(message.text, "a made-up reason") != NULL, "message: %s", message.text) && stays(g, path);
    if (keep)
        setenv("PATH", keep, 1);
    free(keep);
    remove(program);
    rmdir(directory);
    return ok;
}

static bool refuses(gen *g, kind what, const char *path, scene *s)
{
    et_message message;
    bool ok = gen_check(g, draw(what, NULL, s, "t", &message) == ET_EINVAL, "null path");
    double *const x = what == ERRORS || what == HISTORY ? &s->residual[0] : &s->points[gen_upto(g, s->n - 1)].y, keep = *x;

    ok = ok && gen_check(g, what == SHELL || draw(what, "/nonexistent/x.png", s, "t", &message) == ET_EIO, "written nowhere");
    *x = gen_chance(g, 2) ? NAN : INFINITY;
    ok = ok && gen_check(g, what == SHELL || draw(what, path, s, "t", NULL) == ET_EINVAL, "not finite");
    *x = keep;
    return ok && gen_check(g, access(path, F_OK) != 0, "a refused call wrote a file");
}

static verdict picture(gen *g, kind what)
{
    char path[256];
    scene s = {0};
    et_message message = {""};
    const bool drawn = gen_chance(g, RARE);
    const char *const title = titles[gen_upto(g, 6)];
    const bool wide = what == NET || what == ERRORS;
    bool ok = some_scene(g, &s);

    remove(some_path(path, ".png"));
    if (drawn) {
        ok = ok && gen_check(g, draw(what, path, &s, title, &message) == ET_OK, "not drawn: %s", message.text);
        ok = ok && png_is(g, path, wide ? 1600 : 1200, wide ? 800 : 900);
    } else if (gen_chance(g, 50)) {
        ok = ok && without_gnuplot(g, what, path, &s) && with_bad_gnuplot(g, what, path, &s);
    } else {
        ok = ok && refuses(g, what, path, &s);
    }
    remove(path);
    et_shell_free(&s.shell);
    return ok ? PASS : FAIL;
}

verdict prop_plot_cloud(gen *g)
{
    const et_vec3 p = {0, 0, 0};

    if (!gen_check(g, et_plot_cloud("/nonexistent/x", NULL, 1, "", NULL) == ET_EINVAL && et_plot_cloud("/nonexistent/x", &p, 0, "", NULL) == ET_EINVAL,
                   "no points"))
        return FAIL;
    return picture(g, CLOUD);
}

/* More points than are drawn: still a picture, and the same one again. */
/* One case in 2. */
verdict prop_plot_cloud_large(gen *g)
{
    static et_vec3 p[3 * ET_PLOT_MOST];
    char a[256], b[256], *first, *second;
    size_t na, nb;
    bool ok;

    if (!gen_chance(g, 2 * RARE))
        return PASS;
    for (size_t k = 0; k < sizeof p / sizeof *p; k++)
        p[k] = (et_vec3){(double)(k % 100), (double)(k / 100 % 100), (double)(k / 10000)};
    ok = gen_check(g, et_plot_cloud(some_path(a, "-a.png"), p, sizeof p / sizeof *p, "large", NULL) == ET_OK, "not drawn");
    ok = ok && gen_check(g, et_plot_cloud(some_path(b, "-b.png"), p, sizeof p / sizeof *p, "large", NULL) == ET_OK, "not drawn again");
    first = whole_file(a, &na);
    second = whole_file(b, &nb);
    ok = ok && gen_check(g, first && second && na == nb && memcmp(first, second, na) == 0, "two pictures of one cloud");
    free(first);
    free(second);
    remove(a);
    remove(b);
    return ok ? PASS : FAIL;
}

verdict prop_plot_net(gen *g)
{
    const et_vec3 p[4] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const et_doublenet good = {2, 2}, bad = {1, 4};

    if (!gen_check(g, et_plot_net("/nonexistent/x", NULL, good, "", NULL) == ET_EINVAL && et_plot_net("/nonexistent/x", p, bad, "", NULL) == ET_EINVAL,
                   "no net"))
        return FAIL;
    return picture(g, NET);
}

verdict prop_plot_shell(gen *g)
{
    const et_shell none = {0};

    if (!gen_check(g, et_plot_shell("/nonexistent/x", NULL, "", NULL) == ET_EINVAL && et_plot_shell("/nonexistent/x", &none, "", NULL) == ET_EINVAL,
                   "no shell"))
        return FAIL;
    return picture(g, SHELL);
}

verdict prop_plot_error(gen *g)
{
    const double r[4] = {1, 2, 0, gen_chance(g, 2) ? -1e-9 : 1};
    const et_doublenet good = {2, 2}, bad = {4, 1};
    bool ok = gen_check(g, et_plot_error("/nonexistent/x", NULL, good, "", NULL) == ET_EINVAL, "null residuals");

    ok = ok && gen_check(g, et_plot_error("/nonexistent/x", r, bad, "", NULL) == ET_EINVAL, "no net");
    ok = ok && gen_check(g, et_plot_error("/nonexistent/x", r, good, "", NULL) == (r[3] < 0 ? ET_EINVAL : ET_EIO), "negative distance");
    return ok ? picture(g, ERRORS) : FAIL;
}

verdict prop_plot_history(gen *g)
{
    const double value = 1;
    et_plot_curve c = {"c", &value, 1, NAN};
    bool ok = gen_check(g, et_plot_history("/nonexistent/x", NULL, 1, "", NULL) == ET_EINVAL, "null curves");

    ok = ok && gen_check(g, et_plot_history("/nonexistent/x", &c, 0, "", NULL) == ET_EINVAL, "no curve");
    ok = ok && gen_check(g, et_plot_history("/nonexistent/x", &c, 1, "", NULL) == ET_EIO, "written nowhere");
    c.before = INFINITY;
    ok = ok && gen_check(g, et_plot_history("/nonexistent/x", &c, 1, "", NULL) == ET_EINVAL, "infinite before");
    c.before = NAN;
    c.count = 0;
    ok = ok && gen_check(g, et_plot_history("/nonexistent/x", &c, 1, "", NULL) == ET_EINVAL, "curve without values");
    return ok ? picture(g, HISTORY) : FAIL;
}
