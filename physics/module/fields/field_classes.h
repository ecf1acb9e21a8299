#pragma once

namespace fettle::physics_module {

class Hosting;

void define_fields(Hosting& hosting);  // Field and all classes that derive from it

}  // namespace fettle::physics_module
