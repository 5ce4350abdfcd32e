#!/bin/sh
# Who may include whom: one direction, and in core four headers of the language
# and no other. A line of the table: a folder, and the folders it may include
# from besides itself.
set -eu
cd "$(dirname "$0")/../.."

find core drivers port examples -name '*.[ch]' -o -name '*.inc' | sort | xargs awk '
    BEGIN {
        allow("core", "core/base core/format core/raster core/round" \
              " core/smooth core/path core/outline core/hit core/paint" \
              " core/scene core/asset core/image core/fast")
        allow("core/base", "core")
        allow("core/format", "core core/base")
        allow("core/raster", "core core/base core/format")
        allow("core/round", "core core/base core/format core/raster")
        allow("core/outline", "core core/base core/format core/raster" \
              " core/round")
        allow("core/smooth", "core core/base core/format core/raster" \
              " core/round")
        allow("core/path", "core core/base core/raster core/smooth")
        allow("core/hit", "core core/base core/raster core/round")
        allow("core/paint", "core core/base core/format core/raster" \
              " core/round core/smooth")
        allow("core/fast", "core/base core/format core/raster core/paint" \
              " core/scene")
        allow("core/scene", "core core/base core/asset core/format" \
              " core/raster core/paint")
        allow("core/asset", "core core/base")
        allow("core/image", "core core/base core/asset core/format core/raster" \
              " core/smooth core/path")
        allow("drivers", "port")
        allow("port", "drivers")
        allow("examples", "drivers port bench")
        split("stdint.h stdbool.h stddef.h string.h", names, " ")
        for (i in names)
            system_header[names[i]] = 1
    }

    function allow(folder, others,    list, n, i)
    {
        known[folder] = may[folder, folder] = 1
        n = split(others, list, " ")
        for (i = 1; i <= n; i++)
            may[folder, list[i]] = 1
    }

    function complain(what)
    {
        print FILENAME ":" FNR ": " what > "/dev/stderr"
        failed = 1
    }

    function dirname(path) { sub(/\/[^\/]*$/, "", path); return path }

    # The layer of a path: the first folder of drivers and port, two of core.
    function layer(path,    part, n)
    {
        n = split(dirname(path), part, "/")
        return part[1] == "core" && n > 1 ? part[1] "/" part[2] : part[1]
    }

    function resolve(path)
    {
        while (sub(/[^\/.]+\/\.\.\//, "", path))
            ;
        return path
    }

    /^ *# *include *</ {
        name = $0
        sub(/.*</, "", name)
        sub(/>.*/, "", name)
        if (FILENAME !~ /^core\//) {
            if (name ~ /^pel\// && name != "pel/pel.h")
                complain("includes <pel/pel.h>, not <" name ">")
        } else if (!(name in system_header))
            complain("core includes <" name "> (stdint, stdbool, stddef and " \
                     "string only)")
    }

    /^ *# *include *"/ {
        name = $0
        sub(/^[^"]*"/, "", name)
        sub(/".*/, "", name)
        # assets, which make writes
        if (FILENAME ~ /^examples/ && name !~ /^(panel|ppm)\.h$|\//)
            next
        path = FILENAME ~ /^examples/ && name ~ /^(drivers|port)/ ? name \
            : resolve(dirname(FILENAME) "/" name)
        if (FILENAME !~ /^core/ && path ~ /^core/)
            complain("includes core as <pel/...>, not as " name)
        check(name, path)
    }

    function check(name, path,    line, from)
    {
        if ((getline line < path) < 0) {
            complain("\"" name "\" is not at " path)
            return
        }
        close(path)
        from = layer(FILENAME)
        if (!(from in known))
            complain("a folder that the table of layers does not have: " from)
        else if (from == "core" && FILENAME != "core/pel.h")
            complain("only core/pel.h includes from the layers: " name)
        else if (!((from, layer(path)) in may))
            complain(from " may not include from " layer(path) ": " name)
        else if (layer(path) == "core" && path != "core/pel_config.h" && \
                 FILENAME ~ /^core\//)
            complain("core includes the headers that it needs, not " path)
    }

    END { exit failed }'
