#pragma once
// Names from other engines: `pos` for `position`, the key "return" for "enter".

#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

/// Names of properties, methods, keys or buttons that `name` may mean, the most likely first. The
/// part after a blank shows how to write it: "position = vec(x, y)". The caller must check whether
/// there is such a name where it is needed.
std::vector<std::string_view> property_synonyms(std::string_view name);
/// ` (did you mean "angle"?)`: of `meant`, such as the names above, the first one that is known;
/// else the known name nearest to `name`. "" if there is none.
std::string hint_at(const std::vector<std::string_view>& meant, std::string_view name,
                    const std::vector<std::string>& known);

}  // namespace fettle::script

FETTLE_SCRIPT_END
