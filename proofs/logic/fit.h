/* As in doublenet.h; memset of a fit as C has it: zero bits are null pointers; et_status_fail without its sentence (its own unit proves it). */
#include "alloc.h"
#include "doublenet.h"
#include "etalon/fit/fit.h"
#define memset(made, value, bytes) fit_zero(made)
#define et_status_fail(message, status, ...) fit_fail(message, status)
/*@ requires valid: \valid(made);
    assigns  *made;
    ensures  zero:  made->s[0] == \null && made->s[1] == \null && made->r[0] == \null && made->r[1] == \null && made->flat == 0 &&
                    made->shell.view[0].points == \null && made->shell.view[1].points == \null;
*/
void fit_zero(et_fit *made);
/*@ requires message: message == \null || \valid(message);
    assigns  message->text[0 .. ET_MESSAGE_SIZE - 1];
    ensures  status:  \result == status;
*/
et_status fit_fail(et_message *message, et_status status);
