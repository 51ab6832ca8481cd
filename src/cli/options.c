/* options: the table-driven parser of the command line. */
#include "cli/cli.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void print_help(const cli_help *help, const cli_option *options, size_t n)
{
    printf("%s\n\nUsage: %s\n\nOptions:\n", help->what, help->usage);
    for (size_t k = 0; k < n; k++) {
        char left[80];
        snprintf(left, sizeof left, "  %c%c%s --%s%s%s", options[k].letter ? '-' : ' ', options[k].letter ? options[k].letter : ' ',
                 options[k].letter ? "," : " ", options[k].name, options[k].value ? " " : "", options[k].value ? options[k].value : "");
        printf("%-34s %s", left, options[k].help);
        if (options[k].kind == CLI_NAME) {
            printf(" [");
            for (size_t w = 0; options[k].names(w); w++)
                printf("%s%s", w ? ", " : "", options[k].names(w));
            printf("]");
        }
        printf("\n");
    }
    printf("\nExamples:\n%s", help->examples);
    printf("\nExit codes: 0 fine, 1 a comparison failed, 2 usage, 3 bad input, 4 cannot read or write, 5 numerical, 70 internal, 130 interrupted.\n");
}

static int to_size(size_t *value, const char *text, char **end)
{
    errno = 0;
    if (!isdigit((unsigned char)text[0]))
        return 0;
    const unsigned long long v = strtoull(text, end, 10);
    *value = (size_t)v;
    return errno == 0 && (unsigned long long)*value == v;
}

static int to_pair(size_t pair[2], const char *text, char stop)
{
    char *end;
    if (!to_size(&pair[0], text, &end))
        return 0;
    pair[1] = pair[0];
    if (*end == 'x' && !to_size(&pair[1], end + 1, &end))
        return 0;
    return *end == '\0' || *end == stop;
}

static int to_seed(uint64_t *seed, const char *text)
{
    char *end;
    errno = 0;
    if (!isdigit((unsigned char)text[0]))
        return 0;
    const unsigned long long v = strtoull(text, &end, 10);
    *seed = v;
    return errno == 0 && *end == '\0';
}

static int to_real(double *value, const char *text)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

static int to_name(int *value, const char *text, const char *(*names)(size_t))
{
    for (size_t k = 0; names(k); k++)
        if (strcmp(names(k), text) == 0) {
            *value = (int)k;
            return 1;
        }
    return 0;
}

/* Converted into a scratch value first: a refused value leaves the target alone. */
static et_status store(const cli_option *o, const char *text, et_message *message)
{
    size_t size, pair[2];
    double real;
    uint64_t seed;
    int name;
    char *end;

    switch (o->kind) {
    case CLI_FLAG:
        *(int *)o->target = 1;
        return ET_OK;
    case CLI_TEXT:
        *(const char **)o->target = text;
        return ET_OK;
    case CLI_SIZE:
        if (!to_size(&size, text, &end) || *end)
            return et_status_fail(message, ET_EINVAL, "--%s wants a whole number, not '%s'", o->name, text);
        *(size_t *)o->target = size;
        return ET_OK;
    case CLI_PAIR:
        if (!to_pair(pair, text, '\0'))
            return et_status_fail(message, ET_EINVAL, "--%s wants a size such as 20x30, not '%s'", o->name, text);
        memcpy(o->target, pair, sizeof pair);
        return ET_OK;
    case CLI_REAL:
        if (!to_real(&real, text))
            return et_status_fail(message, ET_EINVAL, "--%s wants a finite number, not '%s'", o->name, text);
        *(double *)o->target = real;
        return ET_OK;
    case CLI_SEED:
        if (!to_seed(&seed, text))
            return et_status_fail(message, ET_EINVAL, "--%s wants a whole number below 2^64, not '%s'", o->name, text);
        *(uint64_t *)o->target = seed;
        return ET_OK;
    case CLI_NAME:
        if (!to_name(&name, text, o->names))
            return et_status_fail(message, ET_EINVAL, "--%s does not know '%s'; see --help", o->name, text);
        *(int *)o->target = name;
        return ET_OK;
    }
    return et_status_fail(message, ET_EINTERNAL, "option table is broken at --%s", o->name);
}

static const cli_option *find(const cli_option *options, size_t n, const char *arg, size_t length)
{
    for (size_t k = 0; k < n; k++) {
        if (arg[0] == '-' && arg[1] == '-' && strlen(options[k].name) == length - 2 && strncmp(options[k].name, arg + 2, length - 2) == 0)
            return &options[k];
        if (length == 2 && arg[1] != '-' && arg[1] == options[k].letter)
            return &options[k];
    }
    return NULL;
}

/* One option at argv[*i], and its value. */
static et_status take(int *i, int argc, char **argv, const cli_option *options, size_t n, const cli_help *help, et_message *message)
{
    const char *arg = argv[*i], *equals = arg[1] == '-' ? strchr(arg, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - arg) : strlen(arg);
    const cli_option *o = find(options, n, arg, length);

    if (!o)
        return et_status_fail(message, ET_EINVAL, "unknown option '%s'; see etalon %s --help", arg, help->name);
    if (o->kind == CLI_FLAG) {
        if (equals)
            return et_status_fail(message, ET_EINVAL, "--%s takes no value", o->name);
        return store(o, NULL, message);
    }
    if (equals)
        return store(o, equals + 1, message);
    if (*i + 1 >= argc)
        return et_status_fail(message, ET_EINVAL, "--%s wants a value", o->name);
    *i += 1;
    return store(o, argv[*i], message);
}

et_status cli_parse(const char **positional, size_t *npositional, int argc, char **argv, const cli_option *options, size_t noptions,
                    const cli_help *help, et_message *message)
{
    int plain = 0;

    *npositional = 0;
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help(help, options, noptions);
            *(int *)options[noptions - 1].target = 1;
            return ET_OK;
        }
    for (int i = 1; i < argc; i++) {
        if (!plain && strcmp(argv[i], "--") == 0) {
            plain = 1;
        } else if (!plain && argv[i][0] == '-' && argv[i][1]) {
            const et_status status = take(&i, argc, argv, options, noptions, help, message);
            if (status != ET_OK)
                return status;
        } else {
            if (*npositional >= help->most)
                return et_status_fail(message, ET_EINVAL, "'%s' is one argument too many; usage: %s", argv[i], help->usage);
            positional[(*npositional)++] = argv[i];
        }
    }
    if (*npositional < help->least)
        return et_status_fail(message, ET_EINVAL, "an argument is missing; usage: %s", help->usage);
    if (*(size_t *)options[noptions - CLI_COMMON + 1].target == 0)
        return et_status_fail(message, ET_EINVAL, "--threads must be at least 1");
    return ET_OK;
}

/* --help stays last and --threads second: cli_parse finds them there. */
void cli_common(cli_option options[CLI_COMMON], cli_run *run)
{
    const cli_option common[CLI_COMMON] = {
        { "seed", 0, CLI_SEED, &run->seed, "N", "seed of all that is random (default 1)", NULL },
        { "threads", 0, CLI_SIZE, &run->threads, "N", "threads; results do not depend on it (default 1)", NULL },
        { "json", 0, CLI_FLAG, &run->json, NULL, "print the result as one line of JSON", NULL },
        { "quiet", 'q', CLI_FLAG, &run->quiet, NULL, "say nothing but errors", NULL },
        { "progress", 0, CLI_FLAG, &run->progress, NULL, "show the progress line even off a terminal", NULL },
        { "help", 'h', CLI_FLAG, &run->help, NULL, "this text", NULL },
    };
    memcpy(options, common, sizeof common);
}

et_status cli_list(size_t *chosen, size_t *count, size_t most, const char *text, const char *(*names)(size_t), const char *option, et_message *message)
{
    *count = 0;
    for (const char *at = text; ; ) {
        const size_t length = strcspn(at, ",");
        size_t k = 0;
        while (names(k) && (strlen(names(k)) != length || strncmp(names(k), at, length) != 0))
            k++;
        if (!names(k))
            return et_status_fail(message, ET_EINVAL, "--%s does not know '%.*s'; see --help", option, (int)length, at);
        for (size_t m = 0; m < *count; m++)
            if (chosen[m] == k)
                return et_status_fail(message, ET_EINVAL, "--%s names '%s' twice", option, names(k));
        if (*count == most)
            return et_status_fail(message, ET_EINVAL, "--%s names too many", option);
        chosen[(*count)++] = k;
        if (!at[length])
            return ET_OK;
        at += length + 1;
    }
}

et_status cli_pairs(size_t (*pairs)[2], size_t *count, size_t most, const char *text, const char *option, et_message *message)
{
    *count = 0;
    for (const char *at = text; ; ) {
        const size_t length = strcspn(at, ",");
        if (*count == most)
            return et_status_fail(message, ET_EINVAL, "--%s names more than %zu sizes", option, most);
        if (!to_pair(pairs[*count], at, ','))
            return et_status_fail(message, ET_EINVAL, "--%s wants sizes such as 6x6,12x12, not '%.*s'", option, (int)length, at);
        for (size_t m = 0; m < *count; m++)
            if (memcmp(pairs[m], pairs[*count], sizeof pairs[m]) == 0)
                return et_status_fail(message, ET_EINVAL, "--%s names %zux%zu twice", option, pairs[m][0], pairs[m][1]);
        (*count)++;
        if (!at[length])
            return ET_OK;
        at += length + 1;
    }
}
