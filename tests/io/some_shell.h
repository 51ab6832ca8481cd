/* some_shell: random shells and frames for the tests of io. */
#ifndef TESTS_IO_SOME_SHELL_H
#define TESTS_IO_SOME_SHELL_H
#include "etalon/base/frame.h"
#include "etalon/fit/shell.h"
#include "gen.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Degrees 1..3, sides up to p+4; half are rational; `closed` shares the border.  Sixteenths come often: surfaces closed on themselves too. */
static inline et_status some_shell(gen *g, et_shell *shell, int closed)
{
    const size_t p = 1 + (size_t)gen_upto(g, 2), q = 1 + (size_t)gen_upto(g, 2);
    const et_doublenet net = {p + 1 + (size_t)gen_upto(g, 3), q + 1 + (size_t)gen_upto(g, 3)};
    const et_status status = et_shell_new(shell, p, q, net, (int)gen_upto(g, 1));
    const int flat_u = gen_chance(g, 6), flat_v = gen_chance(g, 6);

    if (status)
        return status;
    gen_knots(g, shell->view[0].u, net.nx + p + 1, p);
    gen_knots(g, shell->view[0].v, net.ny + q + 1, q);
    memcpy(shell->view[1].u, shell->view[0].u, (net.nx + p + 1) * sizeof(double));
    memcpy(shell->view[1].v, shell->view[0].v, (net.ny + q + 1) * sizeof(double));
    for (size_t view = 0; view < 2; view++)
        for (size_t i = 0; i < net.nx; i++)
            for (size_t j = 0; j < net.ny; j++) {
                const size_t k = i * net.ny + j, from = flat_u && i + 1 == net.nx ? j : flat_v && j + 1 == net.ny ? i * net.ny : k;
                const int border = i == 0 || j == 0 || i + 1 == net.nx || j + 1 == net.ny;
                et_surface *const s = &shell->view[view];

                s->points[k] = (et_vec3){gen_real(g, 0, 2), gen_real(g, 0, 1), gen_real(g, -1, 1)};
                if (s->weights)
                    s->weights[k] = gen_real(g, 1, 3);
                if (from != k) {
                    s->points[k] = s->points[from];
                    if (s->weights)
                        s->weights[k] = s->weights[from];
                }
                if (view == 1 && border && closed) {
                    s->points[k] = shell->view[0].points[k];
                    if (s->weights)
                        s->weights[k] = shell->view[0].weights[k];
                }
            }
    return ET_OK;
}

static inline et_frame some_frame(gen *g)
{
    static const double size[] = {1, 3, 1e-3, 1e6, 0x1p100};
    const double s = size[gen_upto(g, 4)];
    const et_frame frame = {{gen_real(g, 0, s), gen_real(g, 0, s), gen_real(g, 0, -s)}, {s, s * gen_real(g, 1, 2), s * gen_real(g, 1, 3)}};

    return frame;
}

/* A name of this process's own, under $TMPDIR, or /dev/shm where it is there (fsync costs nothing), or /tmp. */
static inline const char *some_path(char path[256], const char *ending)
{
    const char *const directory = getenv("TMPDIR");

    snprintf(path, 256, "%s/etalon-test-%ld%s", directory && *directory ? directory : access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp",
             (long)getpid(), ending);
    return path;
}

/* The whole file with a '\0' behind it; null if it cannot be read. */
static inline char *whole_file(const char *path, size_t *size)
{
    FILE *const f = fopen(path, "rb");
    char *text = NULL;

    *size = 0;
    if (!f)
        return NULL;
    if (fseek(f, 0, SEEK_END) == 0) {
        const long n = ftell(f);

        rewind(f);
        text = n >= 0 ? malloc((size_t)n + 1) : NULL;
        if (text) {
            *size = fread(text, 1, (size_t)n, f);
            text[*size] = '\0';
        }
    }
    fclose(f);
    return text;
}
#endif
