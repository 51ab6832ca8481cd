/* answer: Etalon answers a request, by its fast functions or by its exact layer; refused what docs/conformance.md calls invalid. */
#ifndef ETALON_CONFORM_ANSWER_H
#define ETALON_CONFORM_ANSWER_H
#include "etalon/conform/reply.h"
#include "etalon/conform/request.h"
#ifdef __cplusplus
extern "C" {
#endif

/* What Etalon offers: exact != 0 all operations, else those that the fast functions have. */
et_hello et_answer_hello(int exact);
/* *reply is refused where the request is not valid (with the reason), unsupported where hello does not offer it.  ET_ENOMEM only. */
et_status et_answer_fast(et_reply *reply, const et_request *request);
et_status et_answer_exact(et_reply *reply, const et_request *request);

#ifdef __cplusplus
}
#endif
#endif
