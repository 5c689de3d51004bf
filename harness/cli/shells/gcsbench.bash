# Completion of gcsbench for bash: source it, or put it into a folder of bash-completion.
_gcsbench() {
  local line="${COMP_LINE:0:COMP_POINT}" current words
  read -ra words <<<"$line"
  [[ $line == *" " ]] && words+=("")
  mapfile -t COMPREPLY < <("${words[0]}" complete -- "${words[@]:1}" 2>/dev/null)
  # Bash breaks words at = and @ and replaces what follows alone.
  current="${COMP_WORDS[COMP_CWORD]}"
  [[ $current == [=@:] ]] && current=""
  COMPREPLY=("${COMPREPLY[@]#"${words[-1]%"$current"}"}")
  [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
}
complete -o default -F _gcsbench gcsbench
