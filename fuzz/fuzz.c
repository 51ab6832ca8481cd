/* One libFuzzer program for all properties: ET_PROP=basis_eval fuzzer DIRECTORY */
#include "source.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static const property *chosen(void)
{
    const char *name = getenv("ET_PROP");

    for (const property *p = properties; name && p->name; p++)
        if (strcmp(name, p->name) == 0)
            return p;
    fprintf(stderr, "fuzzer: set ET_PROP to the name of a property\n");
    exit(2);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static gen g;
    static const property *p;
    verdict v;

    if (!p)
        p = chosen();
    gen_from_bytes(&g, data, size);
    v = p->run(&g);
    if (v == FAIL)
        abort();
    return v == SKIP ? -1 : 0;
}
