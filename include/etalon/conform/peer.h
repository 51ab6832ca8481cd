/* peer: the program under test: started, asked, killed when it hangs, started again. */
#ifndef ETALON_CONFORM_PEER_H
#define ETALON_CONFORM_PEER_H
#include "etalon/base/task.h"
#include "etalon/conform/reply.h"
#include "etalon/conform/request.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct et_peer et_peer;           /* opaque */

typedef enum { ET_ASKED_REPLY = 0, ET_ASKED_CRASH, ET_ASKED_TIMEOUT, ET_ASKED_GARBLED } et_asked;

/* A program to start.  trace (or null) hears what is said: '>' a line written, '<' bytes read, '!' what happened (started, killed, ended); stop (or
 * null) is asked while a reply is waited for: another status than ET_OK ends the waiting. */
typedef struct {
    const char *command;                  /* run by the shell in a process group of its own */
    double timeout;                       /* seconds for each reply; twice as many for that to hello */
    void (*trace)(void *context, char what, const char *text, size_t length);
    void *context;
    const et_task *stop;
} et_peer_program;

/* In-process use: a function table instead of a program.  Each may be called many times; reply as et_answer_fast. */
typedef struct {
    et_hello hello;
    et_status (*answer)(void *context, et_reply *reply, const et_request *request);
    void *context;
} et_peer_table;

/* Start the program and say hello.  The structs' pointers must live as long as the peer.  ET_EIO (it cannot be started, or the shell ended with 126
 * or 127 without a word), ET_EFORMAT (its hello cannot be read, or it ended or hung instead of one: *how says which), ET_EINVAL (no command, no
 * time), ET_ENOMEM, ET_ESTOPPED.
 * Golden: none (another program's replies). */
/*@ requires peer:    \valid(peer) && \valid(how);
    requires program: \valid_read(program) && (program->command == \null || valid_read_string(program->command));
    requires message: message == \null || \valid(message);
    requires apart:   \separated(peer, how, message);
    ensures  made:    \result == ET_OK ==> *peer != \null && *how == ET_ASKED_REPLY;
    ensures  missing: program->command == \null ==> \result == ET_EINVAL;
    ensures  kept:    \result != ET_OK ==> *peer == \old(*peer);
*/
et_status et_peer_start(et_peer **peer, et_asked *how, const et_peer_program *program, et_message *message);

/* A function table as a peer; its hello is taken as it is.  ET_EINVAL (no answer), ET_ENOMEM.
 * Golden: none (storage). */
/*@ requires peer:  \valid(peer);
    requires table: \valid_read(table);
    assigns  *peer;
    ensures  made:  \result == ET_OK ==> *peer != \null;
    ensures  none:  table->answer == \null ==> \result == ET_EINVAL;
    ensures  kept:  \result != ET_OK ==> *peer == \old(*peer);
*/
et_status et_peer_wrap(et_peer **peer, const et_peer_table *table);

/* The program's input ends; if it has not ended within a second (or its time limit) it is killed, and in any case what is left of its process
 * group.  No zombie stays.  Nothing to do for null.
 * Golden: none (storage). */
/*@ assigns \nothing; */
void et_peer_stop(et_peer *peer);

/* The program and its process group are killed now.  Async-signal-safe: for a handler that ends the process.  Nothing to do for null or a table.
 * Golden: none (no value). */
/*@ assigns \nothing; */
void et_peer_kill(const et_peer *peer);

/* What the peer said to the first hello; it lives as long as the peer.
 * Golden: none (another program's reply). */
/*@ requires peer: peer != \null;
    assigns  \nothing;
    ensures  read: \valid_read(\result);
*/
const et_hello *et_peer_hello(const et_peer *peer);

/* 1 if a hello after a start again was another than the first (in what it offers, not in the order of its words), else 0.
 * Golden: none (another program's reply). */
/*@ requires peer: peer != \null;
    assigns  \nothing;
    ensures  flag: \result == 0 || \result == 1;
*/
int et_peer_changed(const et_peer *peer);

/* One request.  *how: a reply was read, or what came instead (text: a sentence), and then the program has been killed and is started again at the
 * next request:
 *     CRASH    it ended, or closed its input or output;
 *     TIMEOUT  no whole line within the time limit;
 *     GARBLED  a line that is no reply or that of another request, one that came before the request was read or asked for, a line without end.
 * What is read is bounded by what the request can need: with N numbers in it, orders or repetitions r and n_u, n_v knots or control points, no
 * reply has more than (N + 16) (r + 1)^2 + 4 n_u n_v numbers of at most 48 bytes; and never by more than 2^28 bytes.
 * ET_OK whatever the peer does; ET_EIO (it does not start any more, three times in a row), ET_ENOMEM, ET_ESTOPPED.  *reply is set by a reply only.
 * Golden: none (another program's reply). */
/*@ requires peer:    peer != \null && \valid(how) && \valid(reply);
    requires request: \valid_read(request) && et_request_stored((et_request *)request);
    requires text:    text == \null || \valid(text);
    requires apart:   \separated(how, reply, request, text);
    ensures  read:    \result == ET_OK && *how == ET_ASKED_REPLY ==> et_reply_stored(reply);
    ensures  none:    \result == ET_OK && *how != ET_ASKED_REPLY ==> *reply == \old(*reply);
*/
et_status et_peer_ask(et_peer *peer, et_asked *how, et_reply *reply, const et_request *request, et_message *text);

#ifdef __cplusplus
}
#endif
#endif
