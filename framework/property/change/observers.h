#pragma once
// Observers: callbacks that receive every change at once instead of at a barrier.

#include <vector>

#include <fettle/property/observer.h>
// A declaration of WriteLog before that of its header would keep it from being exported.
#include <fettle/property/write_log.h>

#include <guards/lifetime.h>

namespace fettle::property {

struct Observers {
    Lifetime& lifetime;
    std::vector<Observer*> all{};   // null: the observer left during a call
    int running_calls = 0;          // number of nested calls that are running
    std::vector<WriteLog*> logs{};  // also receive the numbering of children

    /// Calls `what(observer)` for each observer. Observers may be added and removed meanwhile.
    template <class What>
    void notify(What what) {
        struct RunningCall {
            Observers& observers;
            Pin pin{observers.lifetime, "an observer"};
            explicit RunningCall(Observers& o) : observers(o) { ++observers.running_calls; }
            ~RunningCall() {
                if (--observers.running_calls == 0) std::erase(observers.all, nullptr);
            }
        } now(*this);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (Observer* const observer = all[i]) what(*observer);
    }
};

}  // namespace fettle::property
