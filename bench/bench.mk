# `make bench`: Pel, built by each compiler, against memset and the installed
# peers. Each build of Pel is one object that shows nothing but its method, so
# that all of them meet in one program and in one run.

-include bench/mcu/mcu.mk

BENCH := $(BUILD)/bench
BENCH_PROGRAM := $(BENCH)/pel-bench
BENCH_REPEATS ?= 21
BENCH_GCC ?= gcc
BENCH_CLANG ?= clang

bench_list = $(foreach method,$(1),X($(method)))

# DejaVu Sans Mono as pictures and as outlines: name, options of pel import
BENCH_FONT := /usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf
bench_font = $(BUILD)/pel import $(BENCH_FONT) --codes 32-126 --name font_$1 $2 -o -;
$(BENCH)/fonts.h: $(BUILD)/pel $(BENCH_FONT)
	@mkdir -p $(@D)
	@set -e; { $(call bench_font,outlines,--outline) \
	    $(call bench_font,4_16,--hinting none --font-size 19) \
	    $(call bench_font,4_24,--hinting none --font-size 29) \
	    $(call bench_font,8_16,--hinting none --bits 8 --font-size 19) } >$@

# name, compiler, flags
define bench_build
$(BENCH)/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$(2) $(PEL_CFLAGS) -I$(BENCH) $(3) -DMETHOD='method_pel_$(subst -,_,$(1))' \
	    -DMETHOD_BUILD='"$(subst -, -,$(1))"' -c $$< -o $$@
$(BENCH)/$(1)/bench/method_pel.o: | $(BENCH)/fonts.h
$(BENCH)/$(1)/libpel.a: $(CORE:%.c=$(BENCH)/$(1)/%.o)
	rm -f $$@
	$(AR) rcs $$@ $$^
$(BENCH)/pel-$(1).o: $(BENCH)/$(1)/bench/method_pel.o $(BENCH)/$(1)/libpel.a
	$(LD) -r -o $$@.all $$^
	objcopy --keep-global-symbol=method_pel_$(subst -,_,$(1)) $$@.all $$@
BENCH_OBJECTS += $(BENCH)/pel-$(1).o
BENCH_DEPENDENCIES += $(CORE:%.c=$(BENCH)/$(1)/%.d) $(BENCH)/$(1)/bench/method_pel.d
BENCH_METHODS += method_pel_$(subst -,_,$(1))
endef

# compiler's short name, command, package
define bench_compiler
ifneq ($$(shell command -v $(2)),)
$$(eval $$(call bench_build,$(1)-O2,$(2),-O2))
$$(eval $$(call bench_build,$(1)-native,$(2),-O3 -march=native))
else
BENCH_ABSENT += compiler $(1): not installed (Debian package $(3)).\n
endif
endef
$(eval $(call bench_compiler,gcc,$(BENCH_GCC),gcc))
$(eval $(call bench_compiler,clang,$(BENCH_CLANG),clang))

BENCH_SOURCES := $(addprefix bench/, bench.c canvas.c coverage.c \
    measure.c method_memset.c methods.c report_csv.c report_table.c \
    report_verdict.c timing.c workload.c workload_circle.c workload_polygon.c \
    workload_triangle.c)
BENCH_METHODS += method_memset

# method, name of pkg-config, Debian package
define bench_peer
ifeq ($$(shell pkg-config --exists $(2) && echo yes),yes)
BENCH_SOURCES += bench/peer_$(1).c
BENCH_METHODS += method_$(1)
BENCH_FLAGS_$(1) := $$(shell pkg-config --cflags $(2))
BENCH_LIBRARIES += $$(shell pkg-config --libs $(2))
else
BENCH_ABSENT += peer $(1): not installed (Debian package $(3)).\n
endif
endef
$(eval $(call bench_peer,allegro,allegro,liballegro4-dev))
$(eval $(call bench_peer,sdl2,sdl2,libsdl2-dev))
$(eval $(call bench_peer,cairo,cairo,libcairo2-dev))
$(eval $(call bench_peer,pixman,pixman-1,libpixman-1-dev))
$(eval $(call bench_peer,freetype,freetype2,libfreetype-dev))
$(eval $(call bench_peer,osmesa,osmesa,libosmesa6-dev))

# The same for libraries without a C interface: one C++ file each.
define bench_peer_cpp
ifeq ($$(shell pkg-config --exists $(2) && command -v $(CXX) >/dev/null && echo yes),yes)
BENCH_METHODS += method_$(1)
BENCH_FLAGS_$(1) := $$(subst -I/,-isystem /,$$(shell pkg-config --cflags $(2)))
BENCH_LIBRARIES += $$(shell pkg-config --libs $(2))
BENCH_OBJECTS += $(BENCH)/host/bench/peer_$(1).o
else
BENCH_ABSENT += peer $(1): not installed (Debian packages $(3) and g++).\n
endif
endef
$(eval $(call bench_peer_cpp,qt5,Qt5Gui,qtbase5-dev))
$(eval $(call bench_peer_cpp,agg,libagg,libagg-dev))
# AGG's fonts are a library of their own, on FreeType.
BENCH_FLAGS_agg += $(subst -I/,-isystem /,$(shell pkg-config --cflags freetype2))
ifneq ($(filter method_agg,$(BENCH_METHODS)),)
BENCH_LIBRARIES := -laggfontfreetype_pic $(BENCH_LIBRARIES) $(shell pkg-config --libs freetype2)
endif
# gcc does not see that AGG's outlines always set what they are asked for.
BENCH_FLAGS_agg += -Wno-maybe-uninitialized

BENCH_OBJECTS += $(BENCH_SOURCES:%.c=$(BENCH)/host/%.o)

$(BENCH)/host/bench/methods.o: bench/bench.mk
$(BENCH)/host/bench/methods.o: PEL_CFLAGS += \
    -DBENCH_METHODS='$(call bench_list,$(BENCH_METHODS))' -DBENCH_ABSENT='"$(subst .\n ,.\n,$(BENCH_ABSENT))"'
$(BENCH)/host/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -O2 $(BENCH_FLAGS_$(patsubst peer_%,%,$(*F))) -c $< -o $@

$(BENCH)/host/%.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) -std=c++17 -Wall -Wextra $(WERROR) -O2 -fPIC -I. -Iinclude -MMD -MP \
	    $(BENCH_FLAGS_$(patsubst peer_%,%,$(*F))) -c $< -o $@

$(BENCH_PROGRAM): $(BENCH_OBJECTS)
	$(CC) $^ $(BENCH_LIBRARIES) -lstdc++ -lm -o $@

# Qt with AVX2 or without: bench/atlas/run.sh says why.
.PHONY: bench
bench: $(BENCH_PROGRAM) ## time Pel, memset and the installed peers
	QT_NO_CPU_FEATURE=avx2 $(BENCH_PROGRAM) --repeats $(BENCH_REPEATS) \
	    --skip alpha --csv $(BENCH)/speed.csv
	$(BENCH_PROGRAM) --repeats $(BENCH_REPEATS) \
	    --only alpha --csv $(BENCH)/speed.csv --append

BENCH_COUNT_SOURCES := $(addprefix bench/, canvas.c count.c workload.c \
    workload_circle.c workload_polygon.c workload_triangle.c)
BENCH_COUNT_OBJECTS := $(BENCH_COUNT_SOURCES:%.c=$(BENCH)/host/%.o) \
    $(BENCH)/count/methods.o $(filter %-O2.o,$(BENCH_OBJECTS))

$(BENCH)/count/methods.o: bench/methods.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -DBENCH_METHODS='$(call bench_list,$(filter %_O2,$(BENCH_METHODS)))' \
	    -DBENCH_ABSENT='""' -c $< -o $@

$(BENCH)/pel-count: $(BENCH_COUNT_OBJECTS)
	$(CC) $^ -lm -o $@

.PHONY: bench-instructions bench-valgrind
bench-valgrind:
	@command -v valgrind >/dev/null || { echo "pel: bench: valgrind is not" \
	    "installed; install the Debian package valgrind" >&2; exit 2; }
$(BENCH)/host/bench/count.o: | bench-valgrind
bench-instructions: $(BENCH)/pel-count ## count Pel's instructions per shape
	bench/instructions.sh $(BENCH)/pel-count $(BENCH)/instructions.csv

-include $(BENCH_SOURCES:%.c=$(BENCH)/host/%.d) $(BENCH_DEPENDENCIES) \
    $(BENCH)/host/bench/count.d $(wildcard $(BENCH)/host/bench/peer_*.d) \
    $(BENCH)/count/methods.d

# The 3-D pipeline, from the library as the user builds it; meshes are read by
# the host program's reader.
BENCH_SCENE_SOURCES := $(addprefix bench/, scene.c scene_mesh.c scene_time.c \
    timing.c)
ifneq ($(filter method_osmesa,$(BENCH_METHODS)),)
BENCH_SCENE_SOURCES += bench/scene_osmesa.c
BENCH_SCENE_LIBS := $(shell pkg-config --libs osmesa)
$(BENCH)/host/bench/scene_time.o: PEL_CFLAGS += -DBENCH_OSMESA
endif
BENCH_SCENE_OBJECTS := $(BENCH_SCENE_SOURCES:%.c=$(BENCH)/host/%.o) \
    $(BENCH)/scene/methods.o $(filter-out $(BUILD)/sim/main.o,$(SIM_OBJECTS)) \
    $(LINUX_OBJECTS)

$(BENCH)/scene/methods.o: bench/methods.c
	@mkdir -p $(@D)
	$(CC) $(PEL_CFLAGS) -DBENCH_METHODS= -DBENCH_ABSENT='""' -c $< -o $@

$(BENCH)/pel-bench-scene: $(BENCH_SCENE_OBJECTS) $(BUILD)/libpel.a
	$(CC) $(LDFLAGS) $^ $(SIM_LIBS) $(LINUX_LIBS) $(BENCH_SCENE_LIBS) \
	    -o $@

# Meshes that no package has are looked for in the folder PEL_MESHES.
.PHONY: bench-scene
bench: bench-scene
bench-scene: $(BENCH)/pel-bench-scene ## time the 3-D pipeline
	$(BENCH)/pel-bench-scene $(BENCH)/scene.csv

-include $(BENCH_SCENE_SOURCES:%.c=$(BENCH)/host/%.d)

include bench/atlas/atlas.mk
-include bench/atlas/run.mk
