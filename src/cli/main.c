/* etalon: the command. */
#include "cli/cli.h"
#include <string.h>
#include <unistd.h>

#define ETALON_VERSION "0.1.0"

typedef struct {
    const char *name, *what;
    et_status (*run)(int argc, char **argv, et_message *message);
} command;

static const command commands[] = {
    { "generate", "one of the four test clouds, at any size, with noise and outliers", cli_generate },
    { "train", "organise a cloud by the Double Net SOM", cli_train_command },
    { "fit", "fit two B-spline surfaces to a trained net", cli_fit_command },
    { "refine", "move the control points: GA, DE, PSO, Ceres, or the certified optimum", cli_refine_command },
    { "evaluate", "points and derivatives of a surface, correctly rounded if asked", cli_evaluate },
    { "compare", "least squares against the refiners, as a table", cli_compare },
    { "reconstruct", "all steps: cloud to closed surface, CAD files, pictures, report", cli_reconstruct },
    { "conform", "judge another implementation: its answers against the exact ones", cli_conform },
    { "serve", "answer the conformance protocol, correctly rounded if asked", cli_serve },
};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

static void usage(FILE *stream)
{
    fprintf(stream, "etalon %s: a point cloud becomes a closed NURBS surface without gaps.\n\nUsage: etalon COMMAND [arguments]\n\nCommands:\n",
            ETALON_VERSION);
    for (size_t k = 0; k < COMMANDS; k++)
        fprintf(stream, "  %-12s %s\n", commands[k].name, commands[k].what);
    fprintf(stream, "\n`etalon COMMAND --help` tells its options, with examples; `man etalon` tells all.\n"
                    "\nExamples:\n"
                    "  etalon generate sphere -o sphere.xyz\n"
                    "  etalon reconstruct sphere.xyz --grid 20x20 --control 12x12 --refine de --seed 1 -o out\n");
}

int main(int argc, char **argv)
{
    et_message message = { "" };

    cli_signals();
    cli_memory();
    if (argc < 2) {
        usage(stderr);
        return 2;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0) {
        usage(stdout);
        return fflush(stdout) != 0 ? 4 : 0;
    }
    if (strcmp(argv[1], "--version") == 0) {
        printf("etalon %s\n", ETALON_VERSION);
        return fflush(stdout) != 0 ? 4 : 0;
    }
    for (size_t k = 0; k < COMMANDS; k++)
        if (strcmp(argv[1], commands[k].name) == 0) {
            et_status status = commands[k].run(argc - 1, argv + 1, &message);
            if ((fflush(stdout) != 0 || ferror(stdout)) && status == ET_OK)
                status = et_status_fail(&message, ET_EIO, "cannot write to standard output");
            if (status != ET_OK)
                fprintf(stderr, "etalon %s: %s\n", argv[1], message.text[0] ? message.text : et_status_text(status));
            /* After a failure the libraries' own shutdown is left out: without memory OpenBLAS waits for its threads for ever. */
            if (status != ET_OK && fflush(NULL) == 0)
                _exit(et_status_exit(status));
            return et_status_exit(status);
        }
    fprintf(stderr, "etalon: unknown command '%s'; see etalon --help\n", argv[1]);
    return 2;
}
