/* train: a cloud becomes a trained double net. */
#include "cli/cli.h"
#include "etalon/io/cloud.h"
#include <string.h>

static et_status finish(const et_net_file *net, double seconds, const char *output, const cli_run *run, et_message *message)
{
    et_status status = output ? et_json_write_net(output, net, message) : ET_OK;

    if (status == ET_OK && run->json) {
        json_t *object = cli_json_som(net, seconds);
        status = cli_print(object, message);
        json_decref(object);
    } else if (status == ET_OK && !run->quiet && !(output && strcmp(output, "-") == 0)) {
        printf("grid %zux%zu  NON %zu  NOV %zu  NOR %zu\n", net->net.nx, net->net.ny, et_doublenet_non(net->net), et_doublenet_nov(net->net),
               et_doublenet_nor(net->net));
        printf("while training  QE %.6f  TE %.6f  min %.6f  max %.6f\n", net->training.qe, net->training.te, net->training.min_error,
               net->training.max_error);
        printf("after training  QE %.6f  TE %.6f  min %.6f  max %.6f  (all points)\n", net->final.qe, net->final.te, net->final.min_error,
               net->final.max_error);
        printf("CPU time %.3f s\n", seconds);
    }
    return status;
}

et_status cli_train_command(int argc, char **argv, et_message *message)
{
    cli_train_options o = cli_train_defaults();
    cli_run run = cli_run_defaults();
    const char *positional[1], *output = NULL;
    int frame = ET_FRAME_BOX;
    double seconds = 0;
    size_t n;
    et_cloud cloud;
    et_net_file net;
    cli_option options[2 + CLI_TRAIN_OPTIONS + CLI_COMMON] = {
        { "output", 'o', CLI_TEXT, &output, "FILE", "the net file (JSON)", NULL },
        { "exact", 0, CLI_FLAG, &run.exact, NULL, "the quality after training correctly rounded, winners found exactly", NULL },
    };
    const cli_help help = { "train", "etalon train CLOUD [options]", "Organise an unstructured cloud by the Double Net SOM.",
                            "  etalon train sphere.xyz --grid 20x20 --seed 1 -o net.json\n  etalon train scan.ply --grid 30x30 --iterations 100000 --json\n",
                            1, 1 };

    cli_train_table(options + 2, &o, &frame);
    cli_common(options + 2 + CLI_TRAIN_OPTIONS, &run);
    et_status status = cli_parse(positional, &n, argc, argv, options, 2 + CLI_TRAIN_OPTIONS + CLI_COMMON, &help, message);
    if (status != ET_OK || run.help)
        return status;
    cli_end_at_once();
    o.frame = (et_frame_kind)frame;
    run.input = positional[0];
    status = et_cloud_read(&cloud, positional[0], message);
    if (status != ET_OK)
        return status;
    status = cli_check(message);
    if (status == ET_OK)
        status = cli_train(&net, &seconds, cloud.points, cloud.count, &o, &run, message);
    et_cloud_free(&cloud);
    if (status != ET_OK)
        return status;
    status = finish(&net, seconds, output, &run, message);
    et_json_free_net(&net);
    return status;
}
