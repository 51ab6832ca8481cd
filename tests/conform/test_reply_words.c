/* conform/reply: words too long to be repeated whole. */
#include "etalon/conform/reply.h"
#include "gen.h"
#include <stdio.h>
#include <string.h>

verdict prop_reply_parse_long_word(gen *g);
verdict prop_reply_hello_long_word(gen *g);

enum { SHOWN = 40, MOST = 100 };

/* The word as a message repeats it: its first 40 letters. */
static bool repeats(gen *g, const et_message *message, const char *word, size_t n)
{
    char quoted[MOST + 8];

    snprintf(quoted, sizeof quoted, "'%.*s' ", (int)(n < SHOWN ? n : SHOWN), word);
    return gen_check(g, strstr(message->text, quoted) != NULL, "'%s' does not repeat %s", message->text, quoted);
}

static size_t letters(gen *g, char word[MOST + 1])
{
    const size_t n = gen_between(g, 1, MOST);

    for (size_t i = 0; i < n; i++)
        word[i] = (char)('g' + gen_upto(g, 15));
    word[n] = '\0';
    return n;
}

/* One case in 10. */
verdict prop_reply_parse_long_word(gen *g)
{
    static const struct { const char *before, *says; } all[] = {
        { "", "is not the number of a request" }, { "3 ", "is not one of ok, refused, unsupported" }, { "3 ok 1 ", "number 2: " } };
    const size_t k = gen_upto(g, 2);
    char word[MOST + 1], line[MOST + 20];
    const size_t n = letters(g, word);
    et_message message = { "" };
    et_reply reply;
    uint64_t id = 9;

    if (strcmp(word, "ok") == 0 || strcmp(word, "inf") == 0 || strcmp(word, "nan") == 0)
        return SKIP;
    snprintf(line, sizeof line, "%s%s", all[k].before, word);
    return gen_check(g, et_reply_parse(&reply, &id, line, &message) == ET_EFORMAT && id == 9, "%s is read", line) && repeats(g, &message, word, n)
                   && gen_check(g, strstr(message.text, all[k].says) != NULL, "%s", message.text) ? PASS : FAIL;
}

/* One case in 10. */
verdict prop_reply_hello_long_word(gen *g)
{
    char word[MOST + 1], line[MOST + 60];
    const size_t n = letters(g, word);
    et_message message = { "" };
    et_hello hello;

    snprintf(line, sizeof line, "protocol=1 name=a %s version=1 ops=span", word);
    return gen_check(g, et_reply_hello(&hello, line, &message) == ET_EFORMAT, "%s is read", line) && repeats(g, &message, word, n)
                   && gen_check(g, strncmp(message.text, "hello: ", 7) == 0 && strstr(message.text, "is not key=value") != NULL, "%s", message.text)
               ? PASS : FAIL;
}
