/* exit: in the coverage build a program that leaves by _exit tells first which lines it has reached. */
#include <stdlib.h>

void __gcov_dump(void);
void __real__exit(int code);
void __wrap__exit(int code);

void __wrap__exit(int code)
{
    __gcov_dump();
    __real__exit(code);
}
