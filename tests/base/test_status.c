/* The texts, the exit codes and the formatted message of base/status. */
#include "etalon/base/status.h"
#include "gen.h"
#include "golden.h"
#include <stdio.h>
#include <string.h>

enum { STATUSES = ET_EDIFFER + 1 };

verdict prop_status_text(gen *g)
{
    int a = (int)gen_upto(g, STATUSES - 1), b = (int)gen_upto(g, STATUSES - 1);
    int outside = gen_chance(g, 2) ? -1 - (int)gen_upto(g, 1000) : STATUSES + (int)gen_upto(g, 1000);
    const char *x = et_status_text((et_status)a), *y = et_status_text((et_status)b);
    bool ok = gen_check(g, x && y && x[0] && strcmp(x, "unknown status") != 0, "status %d has no text", a);
    ok = ok && gen_check(g, (a == b) == (strcmp(x, y) == 0), "statuses %d and %d: \"%s\", \"%s\"", a, b, x, y);
    ok = ok && gen_check(g, strcmp(et_status_text((et_status)outside), "unknown status") == 0, "%d is no status", outside);
    return ok ? PASS : FAIL;
}

verdict prop_status_exit(gen *g)
{
    /* Written down a second time, as the manual page has it. */
    static const struct { et_status status; int code; } table[] = {{ET_OK, 0},     {ET_EDIFFER, 1}, {ET_EINVAL, 2},    {ET_EFORMAT, 3},  {ET_EIO, 4},
                                                                   {ET_ERANK, 5},  {ET_ENOCONV, 5}, {ET_EINTERNAL, 70}, {ET_ENOMEM, 70}, {ET_ESTOPPED, 130}};
    size_t k = (size_t)gen_upto(g, STATUSES - 1);
    int outside = gen_chance(g, 2) ? -1 - (int)gen_upto(g, 1000) : STATUSES + (int)gen_upto(g, 1000);
    int code = et_status_exit(table[k].status);
    bool ok = gen_check(g, sizeof table / sizeof *table == STATUSES, "a status is missing in the table");
    ok = ok && gen_check(g, code == table[k].code, "status %d: exit code %d for %d", (int)table[k].status, code, table[k].code);
    ok = ok && gen_check(g, et_status_exit((et_status)outside) == 70, "%d is no status", outside);
    return ok ? PASS : FAIL;
}

verdict prop_status_fail(gen *g)
{
    et_message m, empty = {"x"};
    char want[3 * ET_MESSAGE_SIZE], word[2 * ET_MESSAGE_SIZE];
    et_status status = (et_status)gen_upto(g, STATUSES - 1);
    size_t n = gen_chance(g, 4) ? ET_MESSAGE_SIZE - 8 + (size_t)gen_upto(g, 16) : (size_t)gen_upto(g, 2 * ET_MESSAGE_SIZE - 1);
    unsigned number = (unsigned)gen_upto(g, 99999);
    memset(word, 'a' + (int)(number % 26), sizeof word);
    word[n] = '\0';
    int length = snprintf(want, sizeof want, "%s:%u", word, number);
    memset(&m, 0x5a, sizeof m);
    bool ok = gen_check(g, et_status_fail(NULL, status, "%s:%u", word, number) == status, "another status without a message");
    ok = ok && gen_check(g, et_status_fail(&m, status, "%s:%u", word, number) == status, "another status");
    ok = ok && gen_check(g, et_status_fail(&empty, status, "%s", "") == status && empty.text[0] == '\0', "an empty sentence");
    if (length >= ET_MESSAGE_SIZE) {
        gen_label(g, "cut");
        want[ET_MESSAGE_SIZE - 1] = '\0';
    }
    ok = ok && gen_check(g, memchr(m.text, '\0', sizeof m.text) && strcmp(m.text, want) == 0, "another text for %zu letters", n);
    return ok ? PASS : FAIL;
}

verdict gold_status_exit(const row *r)
{
    return row_is_size(r, 0, (size_t)et_status_exit((et_status)(int)row_real(r, 0))) ? PASS : FAIL;
}
