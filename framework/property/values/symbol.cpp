// The table of symbols.

#include <fettle/property/symbol.h>

#include <deque>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>

#include <fettle/property/error.h>

namespace fettle::property {
namespace {

struct Names {
    std::shared_mutex mutex;
    std::deque<std::string> texts{""};  // a deque keeps the addresses of the texts
    std::unordered_map<std::string_view, std::uint32_t> ids{{"", 0}};
};

Names& all_names() {
    static Names instance;
    return instance;
}

}  // namespace

Symbol::Symbol(std::string_view text) {
    Names& all = all_names();
    {
        const std::shared_lock lock(all.mutex);
        if (const auto found = all.ids.find(text); found != all.ids.end()) {
            id_ = found->second;
            return;
        }
    }
    const std::unique_lock lock(all.mutex);
    if (const auto found = all.ids.find(text); found != all.ids.end()) {
        id_ = found->second;
        return;
    }
    if (all.texts.size() > max_count)
        throw Error(ErrorKind::bad_name,
                    "\"" + std::string(text.substr(0, 80)) + "\": there are " +
                        std::to_string(max_count) +
                        " different names already, and names are never given back; number things "
                        "by an underscore and digits, as in ball_17, or keep them in a list");
    id_ = static_cast<std::uint32_t>(all.texts.size());
    all.ids.emplace(all.texts.emplace_back(text), id_);
}

Symbol Symbol::find(std::string_view text) {
    Names& all = all_names();
    const std::shared_lock lock(all.mutex);
    Symbol symbol;
    if (const auto found = all.ids.find(text); found != all.ids.end()) symbol.id_ = found->second;
    return symbol;
}

const std::string& Symbol::text() const {
    Names& all = all_names();
    const std::shared_lock lock(all.mutex);
    return all.texts[id_];
}

}  // namespace fettle::property
