# The libraries that a cross build uses from the machine that compiles: those that consist of headers only. Their folders are
# named by themselves, because /usr/include has the headers of another system.
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "Eigen of the machine that compiles")
set(Catch2_DIR "${CMAKE_CURRENT_LIST_DIR}/catch2" CACHE PATH "Catch2 2 of the machine that compiles")
