# pel::linux, the Linux drivers and port/linux, as linux.mk makes it: with DRM,
# input devices and GPIO lines where pkg-config finds their libraries.
file(GLOB PEL_LINUX ${PEL_DEPENDS} ${PEL_DIR}/drivers/*linux*.c
  ${PEL_DIR}/port/linux/*.c)
list(FILTER PEL_LINUX EXCLUDE REGEX
  "/(display_linux_drm[a-z_]*|evdev|evdev_none|gpio|gpio_[a-z0-9]+)\\.c$")

find_package(PkgConfig)
foreach(package libdrm libevdev libgpiod)
  if(PKG_CONFIG_FOUND)
    pkg_check_modules(PEL_${package} ${package})
  endif()
  list(APPEND PEL_LINUX_INCLUDE ${PEL_${package}_INCLUDE_DIRS})
  list(APPEND PEL_LINUX_LIBRARIES ${PEL_${package}_LIBRARIES})
endforeach()

if(PEL_libdrm_FOUND)
  list(APPEND PEL_LINUX ${PEL_DIR}/drivers/display_linux_drm.c
    ${PEL_DIR}/drivers/display_linux_drm_damage.c)
endif()
if(PEL_libevdev_FOUND)
  list(APPEND PEL_LINUX ${PEL_DIR}/port/linux/evdev.c)
else()
  list(APPEND PEL_LINUX ${PEL_DIR}/port/linux/evdev_none.c)
endif()
if(NOT PEL_libgpiod_FOUND)
  list(APPEND PEL_LINUX ${PEL_DIR}/port/linux/gpio_none.c)
elseif(PEL_libgpiod_VERSION VERSION_LESS 2)
  list(APPEND PEL_LINUX ${PEL_DIR}/port/linux/gpio.c
    ${PEL_DIR}/port/linux/gpio_v1.c)
else()
  list(APPEND PEL_LINUX ${PEL_DIR}/port/linux/gpio.c
    ${PEL_DIR}/port/linux/gpio_v2.c)
endif()

add_library(pel_linux STATIC ${PEL_LINUX})
target_compile_definitions(pel_linux PUBLIC _GNU_SOURCE
  PEL_WITH_DRM=$<BOOL:${PEL_libdrm_FOUND}>
  $<$<BOOL:${PEL_libevdev_FOUND}>:HAVE_LIBEVDEV>
  $<$<BOOL:${PEL_libgpiod_FOUND}>:HAVE_LIBGPIOD>)
target_include_directories(pel_linux SYSTEM PUBLIC ${PEL_LINUX_INCLUDE})
target_compile_options(pel_linux PUBLIC -pthread)
target_link_libraries(pel_linux PUBLIC pel_drivers ${PEL_LINUX_LIBRARIES}
  -pthread)

# Without any of these packages it is built for targets that link it.
set(PEL_HAS_PACKAGE OFF)
if(PEL_LINUX_LIBRARIES)
  set(PEL_HAS_PACKAGE ON)
endif()
option(PEL_WITH_LINUX "build and install pel::linux with all"
  ${PEL_HAS_PACKAGE})
if(PEL_WITH_LINUX)
  list(APPEND PEL_INSTALLED pel_linux)
else()
  set_target_properties(pel_linux PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
