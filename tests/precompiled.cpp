// Nothing but a reason to precompile GoogleTest's header (tests/CMakeLists.txt).
