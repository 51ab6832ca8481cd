/* io/json: any bytes as a net file and as a surface file. */
#include "etalon/io/json.h"
#include "raw.h"
#include <math.h>

typedef union { et_net_file net; et_surface_file surface; } content;
typedef struct {
    et_status (*read)(content *c, const char *path, et_message *message);
    et_status (*write)(const char *path, const content *c, et_message *message);
    void (*free)(content *c);
    bool (*valid)(const content *c);
} reader;

static et_status read_net(content *c, const char *path, et_message *message)
{
    return et_json_read_net(&c->net, path, message);
}

static et_status write_net(const char *path, const content *c, et_message *message)
{
    return et_json_write_net(path, &c->net, message);
}

static void free_net(content *c)
{
    et_json_free_net(&c->net);
}

static bool unit(double x)
{
    return x >= 0 && x <= 1;
}

static bool positive(et_vec3 s)
{
    return s.x > 0 && s.y > 0 && s.z > 0 && et_vec3_finite(&s, 1);
}

static bool valid_quality(const et_som_quality *q)
{
    return q->qe >= 0 && isfinite(q->qe) && unit(q->te) && q->min_error >= 0 && q->min_error <= q->max_error && isfinite(q->max_error);
}

static bool valid_net(const content *c)
{
    const et_net_file *const n = &c->net;

    return et_doublenet_valid(n->net) && et_vec3_finite(n->weights, et_doublenet_nov(n->net)) && et_vec3_finite(&n->frame.offset, 1) &&
           positive(n->frame.scale) && n->options.iterations >= 1 && n->options.alpha0 > 0 && n->options.alpha0 <= 1 && n->options.sigma0 >= 0 &&
           isfinite(n->options.sigma0) && valid_quality(&n->training) && valid_quality(&n->final);
}

static et_status read_surface(content *c, const char *path, et_message *message)
{
    return et_json_read_surface(&c->surface, path, message);
}

static et_status write_surface(const char *path, const content *c, et_message *message)
{
    return et_json_write_surface(path, &c->surface, message);
}

static void free_surface(content *c)
{
    et_json_free_surface(&c->surface);
}

static bool rising(const double *t, size_t n)
{
    bool ok = true;

    for (size_t i = 0; i < n; i++)
        ok = ok && unit(t[i]) && (i == 0 || t[i] >= t[i - 1]);
    return ok;
}

static bool valid_surface(const content *c)
{
    const et_surface_file *const s = &c->surface;
    const et_doublenet d = s->fit.data;
    bool ok = et_shell_valid(&s->fit.shell) && et_doublenet_valid(d) && s->fit.shell.view[0].p >= 1 && s->fit.shell.view[0].q >= 1;

    for (size_t w = 0; ok && w < 2; w++)
        ok = rising(s->fit.s[w], d.nx) && rising(s->fit.r[w], d.ny);
    for (size_t k = 0; ok && s->uv && k < 2 * et_doublenet_nov(d); k++)
        ok = unit(s->uv[k]);
    return ok && positive(s->frame.scale) && et_vec3_finite(&s->frame.offset, 1) && s->error.nov >= 0 && s->error.non >= 0 && s->error.greatest >= 0 &&
           s->error.corner >= 0 && s->seam_gap >= 0 && s->options.p >= 1 && s->options.p < s->options.control.nx && s->options.q >= 1 &&
           s->options.q < s->options.control.ny;
}

/* What was read is written, read and written again: both writings are the same bytes, and so the same bits. */
static bool returns(gen *g, const reader *r, const content *c)
{
    char path[RAW_PATH], *first = NULL, *second = NULL;
    content again;
    et_message message = { "" };
    size_t n = 0, m = 0;
    bool ok = gen_check(g, r->write(some_path(path, ".again"), c, &message) == ET_OK, "write: %s", message.text);

    if (ok)
        first = whole_file(path, &n);
    ok = ok && gen_check(g, r->read(&again, path, &message) == ET_OK, "read again: %s", message.text);
    if (ok) {
        ok = gen_check(g, r->write(path, &again, &message) == ET_OK, "write again: %s", message.text);
        second = whole_file(path, &m);
        r->free(&again);
    }
    ok = ok && gen_check(g, first && second && n == m && memcmp(first, second, n) == 0, "not the same again");
    free(first);
    free(second);
    unlink(path);
    return ok;
}

static verdict read_raw(gen *g, const reader *r, const sample *samples)
{
    static raw_file f;
    content c, was;
    et_message message = { "" };

    if (!raw_draw(g, &f, ".json", samples))
        return FAIL;
    memset(&c, 0xAB, sizeof c);
    memset(&was, 0xAB, sizeof was);
    const et_status status = r->read(&c, f.path, &message);
    bool ok = gen_check(g, status == ET_OK || status == ET_EFORMAT, "status %s", et_status_text(status));
    gen_label(g, status == ET_OK ? "read" : "refused");
    if (status == ET_OK) {
        ok = ok && gen_check(g, r->valid(&c), "what was read is not valid") && returns(g, r, &c);
        r->free(&c);
    } else {
        ok = ok && gen_check(g, memcmp(&c, &was, sizeof c) == 0, "changed on failure") && raw_told(g, &f, &message);
        ok = ok && gen_check(g, r->read(&c, f.path, NULL) == status, "another status without a message");
    }
    unlink(f.path);
    return ok ? PASS : FAIL;
}

#define TEXT(s) { s, sizeof s - 1 }

verdict prop_json_read_net_raw(gen *g)
{
    static const reader net = { read_net, write_net, free_net, valid_net };
    static const sample some[] = {
        TEXT("{\"format\":\"etalon-net\",\"version\":1,\"net\":{\"nx\":2,\"ny\":3,\"non\":12,\"nov\":6,\"nor\":6},\n"
             "\"training\":{\"iterations\":30000,\"alpha0\":0.9,\"sigma0\":0.0,\"seed\":\"18446744073709551615\"},\n"
             "\"quality\":{\"training\":{\"qe\":0.5,\"te\":0.25,\"min_error\":0,\"max_error\":1,\"steps\":9223372036854775807},\n"
             "\"final\":{\"qe\":0.25,\"te\":1,\"min_error\":0.0,\"max_error\":1e308,\"steps\":0}},\n"
             "\"frame\":{\"offset\":[0.0,-1e3,0.0],\"scale\":[1,5e-324,1.0]},\n"
             "\"weights\":[[0,0,-0.0],[0,0.5,0],[0,1,0],[1,0,0],[1,0.5,0],[1,1,0]],\"own\":null}\n"),
        { NULL, 0 } };

    return read_raw(g, &net, some);
}

#define VIEW "{\"p\":1,\"q\":1,\"nu\":2,\"nv\":2,\"u\":[0,0,1,1],\"v\":[0,0,1,1],\n\"points\":[[0,0,0],[0,1,0],[1,0,0],[1,1,0]],\"weights\":"

verdict prop_json_read_surface_raw(gen *g)
{
    static const reader surface = { read_surface, write_surface, free_surface, valid_surface };
    static const sample some[] = {
        TEXT("{\"format\":\"etalon-surface\",\"version\":1,\"fit\":{\"approach\":\"improved\",\"parameters\":\"chord\",\"knots\":\"piegl\",\"algebra\":\"qr\",\n"
             "\"corners\":\"default\",\"p\":1,\"q\":1,\"nx\":2,\"ny\":2},\"error\":{\"nov\":0,\"non\":0,\"greatest\":0,\"corner\":0},\"seam_gap\":0.0,\n"
             "\"closed\":true,\"frame\":{\"offset\":[0,0,0],\"scale\":[1,1,1]},\"data\":{\"nx\":2,\"ny\":2,\"flat\":0,\"bottom\":{\"s\":[0,1],\"r\":[0,1]},\n"
             "\"top\":{\"s\":[0,1],\"r\":[0,1]},\"uv\":null},\n\"views\":{\"bottom\":" VIEW "null},\n\"top\":" VIEW "null}}}\n"),
        TEXT("{\"format\":\"etalon-surface\",\"version\":1,\"fit\":{\"approach\":\"conventional\",\"parameters\":\"exponential\",\"knots\":\"averaging\",\n"
             "\"algebra\":\"svd\",\"corners\":\"free\",\"p\":1,\"q\":1,\"nx\":2,\"ny\":2},\"error\":{\"nov\":1,\"non\":2,\"greatest\":0.5,\"corner\":0},\n"
             "\"seam_gap\":1e-3,\"frame\":{\"offset\":[0,0,0],\"scale\":[1,1,1]},\"data\":{\"nx\":2,\"ny\":2,\"flat\":1,\"bottom\":{\"s\":[0,1],\"r\":[0,1]},\n"
             "\"top\":{\"s\":[0,0.5],\"r\":[0.25,1]},\"uv\":[[0,0],[0,1],[1,0],[1,0.5]]},\n\"views\":{\"bottom\":" VIEW "[1,0.5,2,1]},\n\"top\":" VIEW
             "[1,2,3,4]}}}\n"), { NULL, 0 } };

    return read_raw(g, &surface, some);
}
