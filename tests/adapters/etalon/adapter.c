/* Etalon by its library: the request is read and answered by public functions. */
#include "etalon/conform/answer.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What hello says is printed by hand here: an adapter need not know more than the protocol. */
static void say_hello(void)
{
    const et_hello h = et_answer_hello(0);

    printf("0 ok protocol=1 name=%s-library version=%s rational=%d sides=any,left,right knot_tolerance=%a ops=", h.name, h.version, h.rational, h.knot_tolerance);
    for (int op = 0, said = 0; op < ET_OPS; op++)
        if (h.op[op])
            printf("%s%s", said++ ? "," : "", et_request_name((et_request_op)op));
    putchar('\n');
}

static int answer(char *line)
{
    char *end, *text = NULL;
    const unsigned long long id = strtoull(line, &end, 10);
    et_request request;
    et_reply reply;
    et_message message = { "" };
    et_status status;

    end += strspn(end, " ");
    end[strcspn(end, "\n")] = '\0';
    if (strncmp(end, "hello", 5) == 0) {
        say_hello();
        return 0;
    }
    status = et_request_parse(&request, end, &message);
    if (status == ET_EFORMAT) {
        printf("%llu refused %s\n", id, message.text);
        return 0;
    }
    if (status != ET_OK)
        return 1;
    status = et_answer_fast(&reply, &request);
    et_request_free(&request);
    if (status != ET_OK)
        return 1;
    status = et_reply_print(&text, id, &reply);
    et_reply_free(&reply);
    if (status == ET_OK)
        puts(text);
    free(text);
    return status != ET_OK;
}

int main(void)
{
    char *line = NULL;
    size_t size = 0;
    int bad = 0;

    while (!bad && getline(&line, &size, stdin) > 0) {
        bad = answer(line);
        bad |= fflush(stdout) != 0;
    }
    free(line);
    return bad;
}
