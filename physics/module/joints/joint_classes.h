#pragma once

namespace fettle::physics_module {

class Hosting;

void define_joints(Hosting& hosting);  // Joint and all classes that derive from it

}  // namespace fettle::physics_module
