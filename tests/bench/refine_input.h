/* refine_input: the problem that bench_refine and its peers share, from arithmetic alone: 20 x 20 data and 18 x 18 control points a view, bicubic.
 * 724 data and 580 control classes, numbered bottom view first, then the top's inner nodes, row by row. */
#ifndef TESTS_REFINE_INPUT_H
#define TESTS_REFINE_INPUT_H
#ifdef __cplusplus
extern "C" {
#endif

enum { REFINE_DATA = 20, REFINE_CONTROL = 18, REFINE_NOV = 724, REFINE_CLASSES = 580, REFINE_N = 3 * REFINE_CLASSES, REFINE_EVALUATIONS = 80040 };

typedef struct {
    double knots[REFINE_CONTROL + 4];     /* of both directions */
    double t[REFINE_DATA];                /* parameters of both directions */
    double data[3 * REFINE_NOV];
    double x0[REFINE_N];
    int data_class[2][REFINE_DATA][REFINE_DATA];           /* class - 1 of (view, i, j) */
    int control_class[2][REFINE_CONTROL][REFINE_CONTROL];
} refine_input;

void refine_input_make(refine_input *in);

/* N[0..3] by the textbook; the first of the four functions. */
int refine_input_basis(double N[4], const refine_input *in, double x);

#ifdef __cplusplus
}
#endif
#endif
