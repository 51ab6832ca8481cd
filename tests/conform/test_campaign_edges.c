/* conform/campaign: what is rare: neighbours of what is not offered or not valid, shrinking of what has no order, answers of other shapes. */
#include "conform/campaign_relate.h"
#include "conform/judge_kit.h"

verdict prop_campaign_draw_bad_edits(gen *g);
verdict prop_campaign_draw_room(gen *g);
verdict prop_campaign_vary_bad(gen *g);
verdict prop_campaign_vary_not_offered(gen *g);
verdict prop_campaign_vary_few(gen *g);
verdict prop_campaign_shrink_to(gen *g);
verdict prop_campaign_shrink_many_knots(gen *g);
verdict prop_campaign_relate_shapes(gen *g);
verdict prop_campaign_relate_undecided(gen *g);

static bool prints_as(gen *g, const et_request *q, const char *line)
{
    char *text = NULL;
    const et_status status = et_request_print(&text, q);
    const bool ok = gen_check(g, status == ET_OK && strcmp(text, line) == 0, "'%s', not '%s'", text, line);

    free(text);
    return ok;
}

/* ---- drawing ---- */

/* Edits that cannot be made, whatever is drawn for them. */
/* One case in 1000. */
verdict prop_campaign_draw_bad_edits(gen *g)
{
    static const et_request_op ops[] = { ET_OP_CURVE_REMOVE, ET_OP_CURVE_INSERT };
    const et_hello all = et_answer_hello(1);
    bool ok = true;

    for (size_t k = 0; ok && k < 2; k++)
        for (uint64_t number = 0; ok && number < 2000; number++) {
            char reason[128];
            et_request q;
            ok = gen_check(g, et_campaign_draw(&q, ops[k], ET_CATEGORY_BAD_INPUT, 1, number, &all) == ET_OK, "drawn");
            if (ok) {
                ok = gen_check(g, et_judge_validity(reason, &q) == ET_INVALID, "%s, bad input %llu, is not invalid", et_request_name(ops[k]),
                               (unsigned long long)number);
                et_request_free(&q);
            }
        }
    return ok ? PASS : FAIL;
}

/* What a case may take of memory; more is a failure of that case, and never beyond the end. */
verdict prop_campaign_draw_room(gen *g)
{
    double room[16];
    campaign_maker m;
    const size_t size = 1 + (size_t)gen_upto(g, 15), first = (size_t)gen_upto(g, size), second = (size_t)gen_upto(g, size + 1);

    memset(&m, 0, sizeof m);
    m.room = room;
    m.size = size;
    bool ok = gen_check(g, campaign_array(&m, first) == room && m.status == ET_OK && m.used == first, "the first array");
    const double *x = campaign_array(&m, second);
    const bool fits = second <= size - first;
    ok = ok && gen_check(g, m.status == (fits ? ET_OK : ET_ENOMEM) && x == (fits ? room + first : room) && m.used <= size, "%zu and %zu of %zu",
                         first, second, size);
    return ok ? PASS : FAIL;
}

/* ---- neighbours ---- */

/* A neighbour has the same counts. */
static bool alike(gen *g, const et_request *a, const et_request *b)
{
    bool ok = gen_check(g, a->op == b->op, "another operation");

    for (size_t k = 0; ok && et_request_argument(a->op, k); k++)
        ok = gen_check(g, a->arg[k].count == b->arg[k].count, "%s: %zu, not %zu", et_request_argument(a->op, k)->name, b->arg[k].count,
                       a->arg[k].count);
    return ok;
}

/* What is invalid has neighbours that are: knots that are no numbers, too, which are equal to none. */
/* One case in 1000. */
verdict prop_campaign_vary_bad(gen *g)
{
    const et_hello all = et_answer_hello(1);
    bool ok = true;

    for (int op = 0; ok && op < ET_OPS; op++)
        for (uint64_t number = 0; ok && number < 40; number++) {
            char reason[128];
            et_request q, varied;
            if (et_campaign_draw(&q, (et_request_op)op, ET_CATEGORY_BAD_INPUT, 2, number, &all) != ET_OK)
                return FAIL;
            ok = gen_check(g, et_campaign_vary(&varied, &q, 3, number, &all) == ET_OK, "varied");
            if (ok) {
                ok = alike(g, &q, &varied) && gen_check(g, et_judge_validity(reason, &varied) == ET_INVALID, "%s %llu: valid now",
                                                        et_request_name((et_request_op)op), (unsigned long long)number);
                et_request_free(&varied);
            }
            et_request_free(&q);
        }
    return ok ? PASS : FAIL;
}

/* A request, and a hello that leaves it out in one way. */
typedef struct { const char *line; size_t degree, order; int rational, right; double tolerance; } outside;
#define CURVE(p) \
    p " 8 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+0 0x1p+0 4 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+1 0x0p+0 0x0p+0 " \
    "0x1p+0 0x1p+0 0x0p+0 "
#define PATCH(p, q, ku, kv) p " " q " " ku kv "4 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x1p+0 0x0p+0 0 "
#define BILINEAR PATCH("1", "1", "4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 ", "4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 ")
#define SIX \
    "6 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+1 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+1 0x1p+1 0x0p+0"
static const outside outsiders[] = {
    { "basis_ders 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-1 any 2", 8, 1, 1, 1, 0 },
    { "basis 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-1 right", 8, 8, 1, 0, 0 },
    { "span 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-1", 0, 8, 1, 1, 0 },
    { "span 1 5 0x0p+0 0x0p+0 0x1p-20 0x1p+0 0x1p+0 0x1p-1", 8, 8, 1, 1, 0x1p-2 },
    { "curve_point " CURVE("3") "4 0x1p+0 0x1p+0 0x1p+0 0x1p+0 0x1p-1 any", 8, 8, 0, 1, 0 },
    { "knots piegl 3 5 5 0x0p+0 0x1p-2 0x1p-1 0x1.8p-1 0x1p+0", 2, 8, 1, 1, 0 },
    { "approximate 2 1 3 2 3 2 " SIX, 1, 8, 1, 1, 0 },
    { "approximate 1 2 2 3 2 3 " SIX, 1, 8, 1, 1, 0 },
    { "curve_elevate " CURVE("3") "0 2", 4, 8, 1, 1, 0 }, { "curve_elevate " CURVE("3") "0 1", 2, 8, 1, 1, 0 },
    { "surface_elevate " BILINEAR "v 3", 3, 8, 1, 1, 0 }, { "surface_elevate " BILINEAR "u 3", 3, 8, 1, 1, 0 },
};

/* What hello does not offer has no neighbour that it does, for counts and words stay: it is copied, however often one is asked for. */
/* One case in 1000. */
verdict prop_campaign_vary_not_offered(gen *g)
{
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof outsiders / sizeof *outsiders; k++) {
        const outside *o = &outsiders[k];
        et_request q = kit_parse(o->line), varied;
        for (int way = 0; ok && way < 3; way++) {
            et_hello h = et_answer_hello(1);
            size_t others = 0;
            if (way == 0) {
                h.degree = o->degree;
                h.order = o->order;
                h.rational = o->rational;
                h.right = o->right;
                h.knot_tolerance = o->tolerance;
            } else if (way == 1) {
                h.op[q.op] = 0;
            }
            for (uint64_t number = 0; ok && number < 8; number++) {
                char *text = NULL;
                ok = gen_check(g, et_campaign_vary(&varied, &q, 5, number, &h) == ET_OK && et_request_print(&text, &varied) == ET_OK, "varied");
                others += ok && strcmp(text, o->line) != 0;
                free(text);
                if (ok)
                    et_request_free(&varied);
            }
            /* A knot that is too close may come to be far enough; counts and words do not change. */
            ok = ok && gen_check(g, way == 2 ? others > 0 || q.op == ET_OP_APPROXIMATE : way == 0 && o->tolerance > 0 ? true : others == 0,
                                 "%s, way %d: %zu neighbours", o->line, way, others);
        }
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

/* Invalid ones with hardly a number, for a hello that tells knots apart badly: what is not there is not looked at. */
/* One case in 100. */
verdict prop_campaign_vary_few(gen *g)
{
    static const char *const lines[] = { "span 0 0 0x1p-1", "span 0 1 0x0p+0 0x1p-1", "span 2 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-1",
                                         "greville 3 2 0x0p+0 0x1p+0", "fit_curve 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0 0", "parameters chord 0",
                                         "knots uniform 1 2 0", "surface_error " BILINEAR "0 0 0" };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof lines / sizeof *lines; k++)
        for (uint64_t number = 0; ok && number < 12; number++) {
            char reason[128];
            et_hello h = et_answer_hello(1);
            et_request q = kit_parse(lines[k]), varied;
            h.knot_tolerance = number % 2 ? 0x1p-10 : 0;
            ok = gen_check(g, et_judge_validity(reason, &q) == ET_INVALID && et_campaign_vary(&varied, &q, 4, number, &h) == ET_OK, "%s", lines[k]);
            if (ok) {
                ok = alike(g, &q, &varied) && gen_check(g, et_judge_validity(reason, &varied) == ET_INVALID, "%s: valid now", lines[k]);
                et_request_free(&varied);
            }
            et_request_free(&q);
        }
    return ok ? PASS : FAIL;
}

/* ---- shrinking ---- */

static int decreases(void *context, const et_request *q)
{
    (void)context;
    for (size_t i = 1; i < q->arg[1].count; i++)
        if (q->arg[1].x[i] < q->arg[1].x[i - 1])
            return 1;
    return 0;
}

static int has_nan(void *context, const et_request *q)
{
    (void)context;
    for (size_t i = 0; i < q->arg[1].count; i++)
        if (isnan(q->arg[1].x[i]))
            return 1;
    return 0;
}

static int far_out(void *context, const et_request *q)
{
    (void)context;
    return fabs(q->arg[2].x[0]) >= 0x1p53;
}

static int high_degree(void *context, const et_request *q)
{
    (void)context;
    return q->arg[0].count >= 70;
}

static int between(void *context, const et_request *q)
{
    const et_request_value *u = &q->arg[1];

    (void)context;
    return u->count >= 2 && u->x[0] < q->arg[2].x[0] && q->arg[2].x[0] < u->x[u->count - 1];
}

/* The knots 3, 5 and the parameter 4 in units of 2^-1074: halves of the knots are one number. */
static int least_numbers(void *context, const et_request *q)
{
    return between(context, q) && q->arg[1].x[0] == 0x3p-1074 && q->arg[1].x[q->arg[1].count - 1] == 0x5p-1074;
}

static int four_decreasing(void *context, const et_request *q)
{
    return q->arg[1].count == 4 && decreases(context, q);
}

static int sites_differ(void *context, const et_request *q)
{
    (void)context;
    return q->arg[4].count == 4 && q->arg[5].count == 3 && q->arg[6].count == 4;
}

static int one_rational(void *context, const et_request *q)
{
    (void)context;
    return (q->arg[5].count > 0) != (q->arg[11].count > 0);
}

#define ZERO3 "0x0p+0 0x0p+0 0x0p+0 "
#define ZERO4 "0x0p+0 " ZERO3

/* What is left of requests that are out of order: the least that still shows it. */
/* One case in 200. */
verdict prop_campaign_shrink_to(gen *g)
{
    static const struct { const char *line; et_campaign_fails *fails; const char *least; } all[] = {
        { "span 1 6 0x1p+0 0x1p+0 0x1.8p+1 0x0p+0 0x0p+0 0x0p+0 0x1p-1", decreases, "span 0 2 0x1p+0 0x0p+0 0x0p+0" },
        { "span 2 4 0x1p+0 0x1p+0 0x0p+0 0x0p+0 0x1p-1", decreases, "span 0 2 0x1p+0 0x0p+0 0x0p+0" },
        { "span 1 4 0x1p+0 0x1p+0 0x0p+0 0x0p+0 0x1p-1", four_decreasing, "span 0 4 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0" },
        { "span 1 4 0x3p-1074 0x3p-1074 0x5p-1074 0x5p-1074 0x4p-1074", least_numbers,
          "span 0 2 0x0.0000000000003p-1022 0x0.0000000000005p-1022 0x0.0000000000004p-1022" },
        { "span 2 7 0x0p+0 0x1p+0 0x1p+1 nan 0x1p+2 0x1p+2 0x1p+2 0x1p-1", has_nan, "span 0 1 nan 0x0p+0" },
        { "span 1 4 0x0p+0 0x0p+0 0x1p+60 0x1p+60 0x1.fp+60", far_out, "span 0 0 0x1p+53" },
        { "span 1 4 0x0p+0 0x0p+0 0x1p+60 0x1p+60 -0x1.fp+60", far_out, "span 0 0 0x1p+53" },
        { "span 100 2 0x0p+0 0x1p+0 0x1p-1", high_degree, "span 70 0 0x0p+0" },
        { "span 1 4 0x0.0000000000003p-1022 0x0.0000000000003p-1022 0x0.0000000000005p-1022 0x0.0000000000005p-1022 0x0.0000000000004p-1022", between,
          "span 0 2 0x0p+0 0x1p+0 0x1p-1" },
        { "fit_scattered 1 1 2 0 1 2 0 1 4 0 1 1 1 3 0 1 1 4 1 0 0 0 0 0 0 0 0 0 0 0", sites_differ,
          "fit_scattered 0 0 0 0 4 " ZERO4 "3 " ZERO3 "4 " ZERO4 ZERO4 ZERO3 "0x0p+0" },
        { "seam_gap 0 0 2 0 1 2 0 1 1 0 0 0 1 1 0 0 2 0 1 3 0 1 1 1 0 0 0 0 3", one_rational,
          "seam_gap 0 0 0 0 0 1 0x0p+0 0 0 0 0 0 0 0" },
    };
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++) {
        et_request q = kit_parse(all[k].line);
        ok = gen_check(g, all[k].fails(NULL, &q) && et_campaign_shrink(&q, all[k].fails, NULL, 100000) == ET_OK, "%s", all[k].line);
        ok = ok && prints_as(g, &q, all[k].least);
        et_request_free(&q);
    }
    return ok ? PASS : FAIL;
}

static int different(void *context, const et_request *q)
{
    const size_t *least = context;
    size_t n = q->arg[0].count > 0;

    for (size_t i = 1; i < q->arg[0].count; i++)
        n += q->arg[0].x[i] > q->arg[0].x[i - 1];
    return n >= *least;
}

/* More different knots than are put to equidistant places at once: each becomes simple by itself, none is lost. */
/* One case in 1000. */
verdict prop_campaign_shrink_many_knots(gen *g)
{
    enum { MOST = 260 };
    double u[MOST];
    size_t least = 258;
    et_request q;

    for (size_t i = 0; i < MOST; i++)
        u[i] = 0.5 * (double)i + 0.25;
    if (et_request_new(&q, ET_OP_MULTIPLICITY) != ET_OK || et_request_set(&q, 0, MOST, u) != ET_OK)
        return FAIL;
    bool ok = gen_check(g, et_campaign_shrink(&q, different, &least, 3000) == ET_OK && q.arg[0].count == least && different(&least, &q),
                        "%zu knots are left", q.arg[0].count);
    et_request_free(&q);
    return ok ? PASS : FAIL;
}

/* ---- relations ---- */

/* How the answer of the operation is replaced. */
typedef struct { et_request_op op; size_t how; size_t asked; } replaced;

/* The surface of the reply with another domain, decreasing knots, or none at all. */
static et_status other_surface(et_reply *reply, size_t how)
{
    et_surface s;
    size_t at = 0;
    et_status status = et_reply_get_surface(&s, &at, reply);

    if (status != ET_OK)
        return status;
    double *x = how < 2 ? s.u : s.v;
    const size_t n = how < 2 ? s.nu : s.nv, p = how < 2 ? s.p : s.q;
    et_reply_free(reply);
    for (size_t i = 0; i < n + p + 1; i++)
        x[i] = how == 4 ? -x[i] : how % 2 == 0 ? (i <= p ? -1.0 : x[i]) : i < n ? x[i] : 2.0;
    if (how == 5) {
        const double seven[2] = { 7, 7 };
        status = et_reply_put(reply, seven, 2);
    } else {
        status = et_reply_put_surface(reply, &s);
    }
    et_surface_free(&s);
    return status;
}

/* The curve elsewhere in its parameter. */
static et_status other_curve(et_reply *reply)
{
    et_curve c;
    size_t at = 0;
    et_status status = et_reply_get_curve(&c, &at, reply);

    if (status != ET_OK)
        return status;
    et_reply_free(reply);
    for (size_t i = 0; i < c.n + c.p + 1; i++)
        c.u[i] += 0x1p40;
    status = et_reply_put_curve(reply, &c);
    et_curve_free(&c);
    return status;
}

static et_status replace(void *context, et_reply *reply, const et_request *q)
{
    static const double beyond[6][3] = { { -1, 0, 0 }, { 2, 0, 0 }, { 0, -1, 0 }, { 0, 0x1p60, 0 }, { 1, 0, -1 }, { 1, 0, 0x1p60 } };
    replaced *r = context;
    const et_status status = et_answer_fast(reply, q);

    if (status != ET_OK || q->op != r->op)
        return status;
    r->asked++;
    if (q->op == ET_OP_NET_NODE)
        memcpy(reply->x, beyond[r->how], sizeof beyond[0]);
    return q->op == ET_OP_APPROXIMATE ? other_surface(reply, r->how) : q->op == ET_OP_CURVE_INSERT ? other_curve(reply) : status;
}

/* Replies that are of no use to the second question are wrong, in words that say why. */
/* One case in 1000. */
verdict prop_campaign_relate_shapes(gen *g)
{
    static const struct { const char *relation; et_request_op op; size_t ways; const char *says; } all[] = {
        { "net_node inverts net_class", ET_OP_NET_NODE, 6, "the node is not in the net" },
        { "approximate: translation", ET_OP_APPROXIMATE, 6, "the reply is no surface on [0,1]^2" },
        { "curve_insert keeps the curve", ET_OP_CURVE_INSERT, 1, "the reply is no valid curve or surface with this domain" },
    };
    const et_hello all_of_it = et_answer_hello(0);
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++)
        for (size_t how = 0; ok && how < all[k].ways; how++) {
            replaced r = { all[k].op, how, 0 };
            size_t relation = 0;
            et_judgement j;
            et_request q;
            while (strcmp(et_campaign_relation_name(relation), all[k].relation) != 0)
                relation++;
            ok = gen_check(g, et_campaign_relate(&j, &q, relation, 3, how, &all_of_it, replace, &r) == ET_OK, "%s", all[k].relation);
            if (ok) {
                ok = gen_check(g, r.asked == 1 && j.verdict == ET_VERDICT_WRONG && strstr(j.text, all[k].says) && j.at == SIZE_MAX,
                               "%s, way %zu: %s: %s", all[k].relation, how, et_judge_name(j.verdict), j.text);
                et_request_free(&q);
            }
        }
    return ok ? PASS : FAIL;
}

static et_status never(void *context, et_reply *reply, const et_request *q)
{
    (void)reply;
    (void)q;
    *(size_t *)context += 1;
    return ET_EINTERNAL;
}

/* Questions that came to be invalid, or not what hello offers, or what nobody can decide, are not asked and decide nothing. */
/* One case in 100. */
verdict prop_campaign_relate_undecided(gen *g)
{
    static const struct { const char *line; bool bounded; } all[] = {
        { "span 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 nan", true },            /* invalid */
        { "span 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+1", true },         /* outside the domain: implementation-defined */
        { "basis_ders 1 4 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p-1 any 9", false },      /* of too high an order for this hello */
        /* (3/(7 + 7 sqrt 2) + 3/(3 + sqrt 2) + ...)/4 is too near to the middle of two doubles */
        { "parameters_grid chord 4 4 16 "
          "0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 -0x1.cp+2 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
          "0x1.8p+1 0x0p+0 0x0p+0 0x1.8p+1 0x0p+0 0x0p+0 0x1p+53 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "
          "0x1.8p+1 0x1p+2 0x0p+0 0x1p+2 0x1p+0 0x0p+0 0x1.bffffffffffffp+55 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 "
          "0x1.8p+1 -0x1.8p+1 0x1.cp+2 0x1p+2 0x1p+0 0x0p+0 0x1.bffffffffffffp+55 0x1p+0 0x0p+0 0x0p+0 0x1p+1 0x0p+0", true },
    };
    const et_hello hello = et_answer_hello(1);
    bool ok = true;

    for (size_t k = 0; ok && k < sizeof all / sizeof *all; k++)
        for (int bounds = 0; ok && bounds < 2; bounds++) {
            et_request q = kit_parse(all[k].line);
            et_judgement j = { ET_VERDICTS, 0, 0, 0, 0, 0, "" };
            size_t calls = 0, n = 0;
            et_reply reply;
            campaign_relation r = { "it", &j, NULL, &hello, never, &calls, NULL, 0, 0, -1.0, 1, 0, ET_OK };
            if (bounds ? all[k].bounded : k < 3) {
                double *bound = bounds ? campaign_bounds(&r, &n, &q) : NULL;
                ok = gen_check(g, !bound && (bounds || campaign_asked(&r, &reply, &q, SIZE_MAX) == 0), "there is an answer to %s", all[k].line);
                ok = ok && gen_check(g, r.decided && r.status == ET_OK && j.verdict == ET_VERDICT_UNSUPPORTED && calls == 0, "%s, bounds %d: %d, %d",
                                     all[k].line, bounds, (int)r.status, (int)j.verdict);
            }
            et_request_free(&q);
        }
    return ok ? PASS : FAIL;
}
