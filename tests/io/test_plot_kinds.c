/* io/plot: the same picture again, byte for byte.  gnuplot takes a tenth of a second: few cases. */
#include "etalon/io/plot.h"
#include "some_shell.h"
#include <math.h>

typedef enum { CLOUD, NET, SHELL, ERRORS, HISTORY } kind;

static et_status draw(kind what, const char *path, const et_vec3 *p, const double *x, et_doublenet net, const et_shell *shell)
{
    const et_plot_curve c = {"falls", x, 4, 2};

    switch (what) {
    case CLOUD: return et_plot_cloud(path, p, 6, "t", NULL);
    case NET: return et_plot_net(path, p, net, "t", NULL);
    case SHELL: return et_plot_shell(path, shell, "t", NULL);
    case ERRORS: return et_plot_error(path, x, net, "t", NULL);
    default: return et_plot_history(path, &c, 1, "t", NULL);
    }
}

static verdict again(gen *g, kind what)
{
    const et_doublenet net = {2, 3};
    et_vec3 p[6];
    double x[6];
    char path[2][256], *text[2];
    size_t n[2];
    et_shell shell = {0};
    bool ok = some_shell(g, &shell, 1) == ET_OK;

    for (size_t k = 0; k < 6; k++) {
        p[k] = (et_vec3){gen_real(g, 0, 1), gen_real(g, 0, 1), (double)k};
        x[k] = gen_real(g, 0, 1) + 1.0 / (double)(k + 1);
    }
    for (int k = 0; k < 2; k++) {
        ok = ok && gen_check(g, draw(what, some_path(path[k], k ? "-b.png" : "-a.png"), p, x, net, &shell) == ET_OK, "not drawn");
        text[k] = ok ? whole_file(path[k], &n[k]) : NULL;
    }
    ok = ok && gen_check(g, text[0] && text[1] && n[0] == n[1] && memcmp(text[0], text[1], n[0]) == 0, "another picture");
    for (int k = 0; k < 2; k++) {
        remove(path[k]);
        free(text[k]);
    }
    et_shell_free(&shell);
    return ok ? PASS : FAIL;
}

/* One case in 1000. */
verdict prop_plot_cloud_again(gen *g)
{
    return again(g, CLOUD);
}

/* One case in 1000. */
verdict prop_plot_net_again(gen *g)
{
    return again(g, NET);
}

/* One case in 1000. */
verdict prop_plot_shell_again(gen *g)
{
    return again(g, SHELL);
}

/* One case in 1000. */
verdict prop_plot_error_again(gen *g)
{
    return again(g, ERRORS);
}

/* One case in 1000. */
verdict prop_plot_history_again(gen *g)
{
    return again(g, HISTORY);
}
