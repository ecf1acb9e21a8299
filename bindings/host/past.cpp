#include <cmath>

#include "calls.h"

// Snapshots, and going back in time.

using namespace fettle::host;
namespace property = fettle::property;

fettle_code fettle_hosted_snapshot(fettle_hosted* hosted, const void** bytes, size_t* size) {
    return outside(__func__, hosted, "be saved", [&](Game& game) {
        const void*& begin = needed("bytes", bytes);
        size_t& length = needed("size", size);
        game.snapshot = game.tree.snapshot().to_bytes();
        begin = game.snapshot.data();
        length = game.snapshot.size();
    });
}

fettle_code fettle_hosted_restore(fettle_hosted* hosted, const void* bytes, size_t size) {
    return outside(__func__, hosted, "be restored", [&](Game& game) {
        if (size > 0) needed("bytes", static_cast<const char*>(bytes));
        const std::span saved(static_cast<const std::byte*>(bytes), size);
        game.run_scripts([&] { game.tree.restore(property::Snapshot::from_bytes(saved)); });
        game.note_remarks("the restored state");
    });
}

fettle_code fettle_hosted_rewind(fettle_hosted* hosted, double seconds) {
    return outside(__func__, hosted, "go back", [&](Game& game) {
        if (!std::isfinite(seconds))
            throw Failure{FETTLE_INVALID, "seconds: expected a finite number"};
        game.run_scripts([&] { game.loop.timeline().rewind(seconds); });
    });
}

fettle_code fettle_hosted_go_to(fettle_hosted* hosted, int64_t step) {
    return outside(__func__, hosted, "go to another step", [&](Game& game) {
        game.run_scripts([&] { game.loop.timeline().go_to(step); });
    });
}

fettle_code fettle_hosted_steps(fettle_hosted* hosted, int64_t* step, int64_t* oldest,
                                int64_t* newest) {
    return with(__func__, hosted, [&](Game& game) {
        if (step != nullptr) *step = game.services.clock.step;
        const auto kept = game.loop.timeline().kept_steps();
        if (oldest != nullptr) *oldest = kept.oldest;
        if (newest != nullptr) *newest = kept.newest;
    });
}
