#compdef gcsbench
# Completion of gcsbench for zsh: put it as _gcsbench into a folder of $fpath.
local -a found
found=("${(@f)$(${words[1]} complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
compadd -S '' -- ${(M)found:#*=}
compadd -- ${found:#*=}
_files
