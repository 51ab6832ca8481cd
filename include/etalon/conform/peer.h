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

/* A program to start.  trace (or null) hears what is said: '>' a line written, '<' bytes read, '!' what happened (started, killed, ended); stop (or null) is asked
 * while a reply is waited for: another status than ET_OK ends the waiting. */
typedef struct {
    const char *command;                  /* run by the shell in a process group of its own */
    double timeout;                       /* seconds for each reply, that to hello, too */
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

/* Start the program and say hello.  ET_EIO (it cannot be started), ET_EFORMAT (its hello cannot be read, or it ended or hung instead of one: *how says
 * which), ET_EINVAL, ET_ENOMEM, ET_ESTOPPED. */
et_status et_peer_start(et_peer **peer, et_asked *how, const et_peer_program *program, et_message *message);
et_status et_peer_wrap(et_peer **peer, const et_peer_table *table);
void et_peer_stop(et_peer *peer);
/* Async-signal-safe. */
void et_peer_kill(const et_peer *peer);
const et_hello *et_peer_hello(const et_peer *peer);
int et_peer_changed(const et_peer *peer);
/* One request.  *how: a reply was read, or what came instead (text: a sentence; then the program has been started again, or will be at the next request).
 * ET_OK whatever the peer does; ET_EIO (it cannot be started again), ET_ENOMEM, ET_ESTOPPED. */
et_status et_peer_ask(et_peer *peer, et_asked *how, et_reply *reply, const et_request *request, et_message *text);

#ifdef __cplusplus
}
#endif
#endif
