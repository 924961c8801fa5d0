# Sourced by scripts that build, in the root of the project: sets Ninja for new build folders, and one compiler cache
# for all of them. The libraries are compiled for the programs, for the tests, and again as parts of users' projects
# (tests/consumer).
export CMAKE_GENERATOR=${CMAKE_GENERATOR-Ninja}
export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache} CCACHE_DEPEND=1
export CCACHE_DIR=${CCACHE_DIR-$PWD/build/ccache}
