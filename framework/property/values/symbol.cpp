// The table of symbols.

#include <fettle/property/symbol.h>

#include <deque>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <unordered_map>

#include <fettle/property/error.h>
#include <values/process_data.h>

namespace fettle::property {
namespace {

struct Names {
    std::deque<std::string> texts{""};  // a deque keeps the addresses of the texts
    std::unordered_map<std::string_view, std::uint32_t> ids{{"", 0}};
};

struct AllNames {
    std::shared_mutex mutex;
    std::optional<Names> names{std::in_place};  // none after `free`

    void free() { names.reset(); }
};

AllNames& all_names() {
    return process_data<AllNames>();
}

}  // namespace

Symbol::Symbol(std::string_view text) {
    AllNames& known = all_names();
    {
        const std::shared_lock lock(known.mutex);
        if (known.names) {
            if (const auto found = known.names->ids.find(text); found != known.names->ids.end()) {
                id_ = found->second;
                return;
            }
        }
    }
    const std::unique_lock lock(known.mutex);
    if (!known.names) known.names.emplace();
    Names& all = *known.names;
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
    AllNames& known = all_names();
    const std::shared_lock lock(known.mutex);
    Symbol symbol;
    if (!known.names) return symbol;
    const auto& ids = known.names->ids;
    if (const auto found = ids.find(text); found != ids.end()) symbol.id_ = found->second;
    return symbol;
}

const std::string& Symbol::text() const {
    AllNames& known = all_names();
    {
        const std::shared_lock lock(known.mutex);
        if (known.names && id_ < known.names->texts.size()) [[likely]]
            return known.names->texts[id_];
    }
    // The program is ending, and no tree had the name.
    const std::unique_lock lock(known.mutex);
    if (!known.names) known.names.emplace();
    return known.names->texts[0];
}

}  // namespace fettle::property
