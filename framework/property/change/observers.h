#pragma once
// Who is told of everything at once, and not at a barrier.

#include <vector>

#include <fettle/property/observer.h>

#include <guards/lifetime.h>

namespace fettle::property {

class WriteLog;

struct Observers {
    Lifetime& lifetime;
    std::vector<Observer*> all{};   // null: it left while they were told
    int telling = 0;                // calls of them that go on
    std::vector<WriteLog*> logs{};  // told of numbers, too

    /// Calls `what(observer)` for each. They may come and go meanwhile.
    template <class What>
    void tell(What what) {
        struct Telling {
            Observers& observers;
            Pin pin{observers.lifetime, "an observer"};
            explicit Telling(Observers& o) : observers(o) { ++observers.telling; }
            ~Telling() {
                if (--observers.telling == 0) std::erase(observers.all, nullptr);
            }
        } now(*this);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (Observer* const observer = all[i]) what(*observer);
    }
};

}  // namespace fettle::property
