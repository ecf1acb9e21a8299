// restore and rewind in one frame: each continues from the result of the one before.

#include "catch.h"
#include "program.h"

namespace restore_rewind_test {

using namespace program_test;

TEST_CASE("restore and rewind in one step happen in the order of their calls") {
    const Folder folder;
    const std::string order = GENERATE(as<std::string>{}, "restore(s) rewind(0.5)",
                                       "rewind(0.5) restore(s)", "rewind(0.25) rewind(0.25)");
    const std::string game = folder.write("main.lua", R"lua(
local s, done
function step()
    if time.step == 50 then s = snapshot() end
    if time.step == 100 and not done then
        done = true
        )lua" + order + R"lua(
    end
end
game:on("restored", function() print(time.step) end)
)lua");
    const Outcome outcome = fettle(folder, {"run", game, "--headless", "--steps", "160"});
    CHECK(outcome.err == "");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == (order.starts_with("restore") ? "20\n"
                          : order.ends_with("(s)")     ? "50\n"
                                                       : "70\n"));
}

}  // namespace restore_rewind_test
