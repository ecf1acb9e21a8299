// Calls of every function of fettle_host.h in any order with any arguments, also inside the
// functions that a game calls: the input chooses them. The game must work afterwards.

#include <cstdio>
#include <cstdlib>

#include <host/every_call.h>

using namespace random_hosting;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Arguments arguments{Numbers(data, size)};
    for (int i = 0; i < 300 && !arguments.ended(); ++i) any_call(arguments);
    for (int i = 0; i < 2; ++i) {
        fettle_hosted* const game = arguments.game(i);
        (void)fettle_hosted_on_print(game, nullptr, nullptr);
        (void)fettle_hosted_on_problem(game, nullptr, nullptr);
        fettle_hosted_value result;
        if (fettle_hosted_evaluate(game, "1 + 1", &result, nullptr) == FETTLE_DONE) continue;
        std::fprintf(stderr, "1 + 1: %s\n", fettle_last_error());
        std::abort();
    }
    return 0;
}
