/* One program fuzzes every property, under libFuzzer and under AFL++: ET_PROP=basis_eval fuzzer DIRECTORY
 * Without ET_PROP the property is the one that the program's own name says: for hosts that want a program a target. */
#include "source.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static const property *chosen;

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    const char *name = getenv("ET_PROP");

    if (!name && *argc > 0)
        name = strrchr((*argv)[0], '/') ? strrchr((*argv)[0], '/') + 1 : (*argv)[0];
    for (const property *p = properties; name && p->name; p++)
        if (strcmp(name, p->name) == 0)
            chosen = p;
    if (!chosen) {
        fprintf(stderr, "fuzzer: set ET_PROP to the name of a property, not %s\n", name ? name : "");
        exit(2);
    }
    return 0;
}

/* A case that is none adds nothing to a corpus: -1, which AFL++ does not mind. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static gen g;
    verdict v;

    gen_from_bytes(&g, data, size);
    v = chosen->run(&g);
    if (v == FAIL)
        abort();
    return v == SKIP ? -1 : 0;
}
