# ESP-IDF reads the file of a component as a script first, in a function, and
# what registers the component returns from it.
macro(idf_component_register)
  set(registered 1)
  return()
endmacro()
function(requirements)
  include(pel/CMakeLists.txt)
  set(registered ${registered} PARENT_SCOPE)
endfunction()
requirements()
if(NOT registered)
  message(FATAL_ERROR "the component is not registered")
endif()
