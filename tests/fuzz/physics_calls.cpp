// Calls of every function of fettle_physics.h in any order with any arguments, also inside the
// functions that worlds call: the input chooses them. The worlds must stay consistent.

#include <cstdio>
#include <cstdlib>

#include <physics_c/every_call.h>

using namespace random_arguments;

namespace {

void check(Arguments& arguments, const char* last) {
    for (int i = 0; i < 3; ++i) {
        const char* fault = nullptr;
        if (fettle_world_validate(arguments.world(i), &fault) != FETTLE_DONE) continue;
        if (fault == nullptr) continue;
        std::fprintf(stderr, "after %s: %s\n", last, fault);
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Arguments arguments{Numbers(data, size)};
    const char* last = "nothing";
    for (int i = 0; i < 500 && !arguments.ended(); ++i) {
        last = any_call(arguments).name;
        if (i % 16 == 0) check(arguments, last);
    }
    check(arguments, last);
    return 0;
}
