/* answer_parts: fast answers by groups of operations; *reply is empty and `ok` before. */
#ifndef CONFORM_ANSWER_PARTS_H
#define CONFORM_ANSWER_PARTS_H
#include "etalon/conform/answer.h"

et_status answer_basis(et_reply *reply, const et_request *request);
et_status answer_point(et_reply *reply, const et_request *request);
et_status answer_edit(et_reply *reply, const et_request *request);
et_status answer_parameters(et_reply *reply, const et_request *request);
et_status answer_fit(et_reply *reply, const et_request *request);
et_status answer_measure(et_reply *reply, const et_request *request);
et_status answer_net(et_reply *reply, const et_request *request);
/* A surface over [0,1]^2 by chord lengths and least squares, exact: each stage exactly and rounded; where data coincide so that the fit has no rank,
 * with uniform parameters. */
et_status answer_approximate(et_reply *reply, const et_request *request, int exact);
#endif
