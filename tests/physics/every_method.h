#pragma once
// Every method of the handles, and every one that edits a world: for rules that hold for all of
// them. A test compares the list with the headers.

#include "one_of_each.h"

namespace scenes {

const std::vector<Method>& every_method();

}  // namespace scenes
