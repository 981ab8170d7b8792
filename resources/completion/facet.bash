# bash completion of facet; the program itself knows what may come next.

_facet() {
  local words cword cur line
  if declare -F _get_comp_words_by_ref >/dev/null; then
    _get_comp_words_by_ref -n := words cword cur # ":" and "=" are within words
  else
    words=("${COMP_WORDS[@]}") cword=$COMP_CWORD cur=${COMP_WORDS[COMP_CWORD]}
  fi
  local before= # what bash takes for words of their own already
  if [[ $cur == *[:=]* && $COMP_WORDBREAKS == *[:=]* ]]; then before=${cur%"${cur##*[:=]}"}; fi
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :folders)
        compopt -o filenames 2>/dev/null
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cur")
        ;;
      :files*)
        compopt -o filenames 2>/dev/null
        local endings=${line#:files} file ending
        while IFS= read -r file; do
          ending=${file##*.}
          if [[ ! -d $file && (-z $endings || "$endings " == *" ${ending,,} "*) ]]; then COMPREPLY+=("$file"); fi
        done < <(compgen -f -- "$cur")
        ;;
      *)
        line=${line%%$'\t'*}
        COMPREPLY+=("${line#"$before"}")
        ;;
    esac
  done < <("${words[0]}" complete -- "${words[@]:1:cword}" 2>/dev/null)
}

complete -F _facet facet
