# Completion of gcsbench for fish: put it into a folder of $fish_complete_path.
function __gcsbench_complete
    set -l words (commandline --tokenize --cut-at-cursor --current-process) (commandline --current-token --cut-at-cursor)
    gcsbench complete -- $words[2..-1] 2>/dev/null
end
complete --command gcsbench --arguments '(__gcsbench_complete)'
