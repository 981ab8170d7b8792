# fish completion of facet; the program itself knows what may come next.

function __facet_complete
    set -l words (commandline -opc) (commandline -ct)
    set -l typed (commandline -ct)
    for line in (command $words[1] complete -- $words[2..-1] 2>/dev/null)
        switch $line
            case :folders
                __fish_complete_directories $typed
            case ':files*'
                set -l endings (string split -n ' ' -- (string replace ':files' '' -- $line))
                if test (count $endings) -eq 0
                    __fish_complete_path $typed
                else
                    for ending in $endings
                        __fish_complete_suffix .$ending
                    end
                end
            case '*'
                echo $line
        end
    end
end

complete -c facet -f -a '(__facet_complete)'
