// The table of symbols.

#include <fettle/property/symbol.h>

#include <deque>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>

#include <fettle/property/error.h>

namespace fettle::property {
namespace {

struct Table {
    std::shared_mutex mutex;
    std::deque<std::string> texts{""};  // a deque keeps the addresses of the texts
    std::unordered_map<std::string_view, std::uint32_t> ids{{"", 0}};
};

Table& table() {
    static Table instance;
    return instance;
}

}  // namespace

Symbol::Symbol(std::string_view text) {
    Table& t = table();
    {
        const std::shared_lock lock(t.mutex);
        if (const auto found = t.ids.find(text); found != t.ids.end()) {
            id_ = found->second;
            return;
        }
    }
    const std::unique_lock lock(t.mutex);
    if (const auto found = t.ids.find(text); found != t.ids.end()) {
        id_ = found->second;
        return;
    }
    if (t.texts.size() > max_count)
        throw Error(ErrorKind::bad_name,
                    "\"" + std::string(text.substr(0, 80)) + "\": there are " +
                        std::to_string(max_count) +
                        " different names already, and names are never given back; number things "
                        "by an underscore and digits, as in ball_17, or keep them in a list");
    id_ = static_cast<std::uint32_t>(t.texts.size());
    t.ids.emplace(t.texts.emplace_back(text), id_);
}

Symbol Symbol::find(std::string_view text) {
    Table& t = table();
    const std::shared_lock lock(t.mutex);
    Symbol symbol;
    if (const auto found = t.ids.find(text); found != t.ids.end()) symbol.id_ = found->second;
    return symbol;
}

const std::string& Symbol::text() const {
    Table& t = table();
    const std::shared_lock lock(t.mutex);
    return t.texts[id_];
}

}  // namespace fettle::property
